/* Discs as points: bare.h says what the numbers mean. */
uniform vec2 size; /* of the picture, device pixels */

in vec2 at;
in vec2 radii;
in vec4 colour;

flat out vec4 v_colour;
flat out vec4 v_disc; /* the middle, as OpenGL counts pixels, and the radii */

void
main ()
{
  v_colour = colour;
  v_disc = vec4 (at.x, size.y - at.y, radii);
  gl_PointSize = 2.0 * max (radii.x, radii.y) + 1.0;
  gl_Position = vec4 (2.0 * at.x / size.x - 1.0, 1.0 - 2.0 * at.y / size.y,
                      0.0, 1.0);
}
