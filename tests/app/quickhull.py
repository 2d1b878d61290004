"""QuickHull by brute force in whole numbers, for a player who knows nothing
but coordinates: who sees what, what is furthest, what is legal."""
from fractions import Fraction
from itertools import combinations


def determinant(a, b, c):
    return (a[0] * (b[1] * c[2] - b[2] * c[1])
            - a[1] * (b[0] * c[2] - b[2] * c[0])
            + a[2] * (b[0] * c[1] - b[1] * c[0]))


class Hull:
    """The hull of the lifts of the sites inserted so far. Facets are sets of
    three sites."""

    def __init__(self, sites):
        self.lifts = [(Fraction(x), Fraction(y), Fraction(x) ** 2
                       + Fraction(y) ** 2) for x, y in sites]
        self.inserted = self.first_simplex()
        self.facets = {frozenset(t) for t in combinations(self.inserted, 3)}

    def first_simplex(self):
        """The first three sites and the first one off their plane."""
        for site in range(3, len(self.lifts)):
            if self.side((0, 1, 2), site) != 0:
                return [0, 1, 2, site]
        raise ValueError("there is no simplex")

    def side(self, facet, site):
        """Of the plane through a facet: a volume with its sign."""
        a, b, c = (self.lifts[i] for i in sorted(facet))
        p = self.lifts[site]
        return determinant(*[tuple(q[k] - p[k] for k in range(3))
                             for q in (a, b, c)])

    def sees(self, site, facet):
        """Whether it lies on the other side of the plane than the hull."""
        inner = next(side for side in (self.side(facet, i)
                                       for i in self.inserted) if side != 0)
        return self.side(facet, site) * inner < 0

    def seen_by(self, site):
        return {f for f in self.facets if self.sees(site, f)}

    def furthest(self, facet, sites):
        """All that are furthest in front of the facet."""
        distances = {s: abs(self.side(facet, s)) for s in sites}
        return {s for s in sites
                if distances[s] == max(distances.values())}

    def horizon(self, site):
        """Ridges, sets of two sites, between a facet that is seen and one
        that is not."""
        seen = self.seen_by(site)
        ridges = {frozenset(r) for f in self.facets
                  for r in combinations(sorted(f), 2)}
        return {r for r in ridges
                if sum(r < f for f in seen) == 1
                and sum(r < f for f in self.facets) == 2}

    def is_lower(self, facet, others):
        """Whether all others lie above its plane, or in it: whether its circle
        is empty."""
        a, b, c = (self.lifts[i] for i in sorted(facet))
        turn = ((b[0] - a[0]) * (c[1] - a[1])
                - (b[1] - a[1]) * (c[0] - a[0]))
        return turn != 0 and all(self.side(facet, s) * turn <= 0
                                 for s in others)

    def new_triangles(self, site):
        others = self.inserted + [site]
        return {r for r in self.horizon(site)
                if self.is_lower(r | {site}, others)}

    def cone(self, site):
        return {r | {site} for r in self.horizon(site)}

    def insert(self, site):
        cone = self.cone(site)
        self.facets -= self.seen_by(site)
        self.facets |= cone
        self.inserted.append(site)
        return cone
