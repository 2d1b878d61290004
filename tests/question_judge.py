"""Answers questions of a bank by definition, in fractions, from their words
alone.
"""
import itertools
import re
from fractions import Fraction


class Fault(Exception):
    """A sentence that turned out false."""


def check(is_true, what):
    if not is_true:
        raise Fault(what)


def turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def lift(p):
    return (p[0], p[1], p[0] * p[0] + p[1] * p[1])


def volume(a, b, c, d):
    """Of the tetrahedron, six times, signed."""
    u, v, w = ([q[i] - d[i] for i in range(3)] for q in (a, b, c))
    return (u[0] * (v[1] * w[2] - v[2] * w[1])
            - u[1] * (v[0] * w[2] - v[2] * w[0])
            + u[2] * (v[0] * w[1] - v[1] * w[0]))


class Scene:
    """What a question says in words."""

    def __init__(self, given):
        self.sites, self.facet = {}, {}
        self.apex, self.outside = None, []
        hull = None
        for line in given:
            for s, x, y in re.findall(r"s(\d+) \(([^,]+), ([^)]+)\)", line):
                self.sites[int(s)] = (Fraction(x), Fraction(y))
            if line.startswith("On the hull so far"):
                hull = [int(n) for n in re.findall(r"s(\d+)", line)]
            if line.endswith("comes next."):
                self.apex = int(re.match(r"s(\d+)", line).group(1))
            if line.startswith("Outside set"):
                self.outside = [int(n) for n in re.findall(r"s(\d+)", line)]
            named = re.match(r"f(\d+) \(([^,)]*)", line)
            if named:
                self.facet[int(named.group(1))] = corners(named.group(2))
        self.active = sorted(self.sites) if hull is None else hull
        self.facets = {}
        for trio in itertools.combinations(self.active, 3):
            signs = {self.side(trio, s) > 0 for s in self.active
                     if s not in trio}
            if len(signs) == 1:
                self.facets[frozenset(trio)] = signs.pop()

    def side(self, trio, site):
        a, b, c = (lift(self.sites[s]) for s in sorted(trio))
        return volume(a, b, c, lift(self.sites[site]))

    def sees(self, site, facet):
        """All others lie on one side of a facet, and site on the other."""
        value = self.side(facet, site)
        check(value != 0, "a tie")
        return (value > 0) != self.facets[facet]

    def visible(self):
        return {f for f in self.facets if self.sees(self.apex, f)}

    def is_lower(self, facet):
        """Straight below its centre there is nothing of the hull."""
        a, b, c = (lift(self.sites[s]) for s in sorted(facet))
        deep = tuple(sum(p[i] for p in (a, b, c)) / 3 - (i == 2)
                     for i in range(3))
        return (volume(a, b, c, deep) > 0) != self.facets[facet]

    def in_circle(self, trio, site):
        a, b, c = (self.sites[s] for s in sorted(trio))
        area = turn(a, b, c)
        rows = [(p[0] - self.sites[site][0], p[1] - self.sites[site][1])
                for p in (a, b, c)]
        (ax, ay), (bx, by), (cx, cy) = rows
        value = ((ax * ax + ay * ay) * (bx * cy - cx * by)
                 - (bx * bx + by * by) * (ax * cy - cx * ay)
                 + (cx * cx + cy * cy) * (ax * by - bx * ay))
        return value * area > 0

    def horizon(self):
        visible = self.visible()
        count = {}
        for facet in visible:
            for edge in itertools.combinations(sorted(facet), 2):
                count[edge] = count.get(edge, 0) + 1
        return {frozenset(e) for e, n in count.items() if n == 1}

    def extreme(self):
        """Corners: some line through the site leaves all others on a side."""
        return {s for s in self.active if any(
            all(turn(self.sites[s], self.sites[t], self.sites[u]) > 0
                for u in self.active if u not in (s, t))
            for t in self.active if t != s)}

    def neighbours(self, site):
        return {t for f in self.facets if site in f and self.is_lower(f)
                for t in f} - {site}


def corners(words):
    return frozenset(int(n) for n in re.findall(r"s(\d+)", words))


def facet_of(text):
    return corners(re.sub(r"^f\d+ ", "", text))


def site_of(text):
    return int(text[1:])


def key(ask, scene, text):
    """Whether an option is right."""
    if ask == "click lower-facets":
        check("lower" not in text and "upper" not in text, "given away")
        return scene.is_lower(facet_of(text))
    if ask == "click visible-facets":
        return facet_of(text) in scene.visible()
    if ask == "click dying-triangles":
        f = facet_of(text)
        check(("lower" in text) == scene.is_lower(f), "the facing")
        return f in scene.visible() and scene.is_lower(f)
    if ask == "click circles":
        return scene.in_circle(corners(text), scene.apex)
    if ask == "click horizon":
        return corners(text) in scene.horizon()
    if ask == "click facets-seen-by s4":
        return scene.sees(4, facet_of(text))
    if ask == "click furthest-site":
        f, s = next(iter(scene.facet.values())), site_of(text)
        return s in scene.outside and all(
            abs(scene.side(f, s)) >= abs(scene.side(f, t))
            for t in scene.outside)
    if ask == "click unbounded-cells":
        return site_of(text) in scene.extreme()
    if ask == "click neighbours s0":
        return site_of(text) in scene.neighbours(0)
    if ask == "choose several":
        if text == "there is a facet":
            return True
        if text == "f0 is {a=b}: ~lower~":
            return scene.is_lower(scene.facet[0])
        site, facet = map(int, re.findall(r"\d+", text))
        return scene.sees(site, scene.facet[facet])
    if ask.startswith("always"):
        return text.startswith("No")
    raise Fault(f"no key for {ask}")


def number(label, scene):
    if label == "facets that are visible" or "visible" in label:
        return len(scene.visible())
    return len(scene.horizon())
