/* How much of a pixel each kind of stroke covers. Colours are premultiplied.
 */
uniform sampler2D names; /* red: the casing, green: the letters */
uniform vec4 ground;     /* the colour of casings */

in vec4 v_colour;
in vec3 v_local;
flat in vec4 v_shape;

out vec4 pixel;

/* Of something so deep inside. */
float
part (float depth)
{
  return clamp (depth + 0.5, 0.0, 1.0);
}

/* Along a line: v_local is the place along, across, and the whole length. */
float
line_part (bool is_round)
{
  float half_width = v_shape.x, dash = v_shape.y, gap = v_shape.z;
  float along = v_local.x, across = v_local.y, end = v_local.z;
  float start = 0.0;

  if (dash > 0.0) {
    /* The nearest dash, and no further than the line goes. */
    float first = floor ((along + 0.5 * gap) / (dash + gap)) * (dash + gap);

    start = max (first, 0.0);
    end = min (first + dash, end);
    if (end < start)
      return 0.0;
  }
  if (is_round) {
    float beyond = max (max (start - along, along - end), 0.0);

    return part (half_width - length (vec2 (beyond, across)));
  }
  return min (part (half_width - abs (across)), 2.0 * half_width)
         * clamp (min (along + 0.5, end) - max (along - 0.5, start), 0.0, 1.0);
}

float
hatch_part ()
{
  vec2 normal = v_shape.xy;
  float step = v_local.z;
  float level = dot (normal, v_local.xy);
  float off = abs (mod (level + 0.5 * step, step) - 0.5 * step);

  return part (v_shape.z - off / length (normal));
}

void
main ()
{
  int kind = int (v_shape.w + 0.5);

  if (kind == 0) {
    pixel = v_colour;
  } else if (kind <= 2) {
    pixel = v_colour * line_part (kind == 2);
  } else if (kind == 3) {
    float off = length (v_local.xy);

    pixel = v_colour * max (part (v_shape.y - off) - part (v_shape.x - off), 0.0);
  } else if (kind == 4) {
    pixel = v_colour * hatch_part ();
  } else {
    vec2 name = texture (names, v_local.xy).rg;

    pixel = ground * name.r * (1.0 - name.g * v_colour.a) + v_colour * name.g;
  }
}
