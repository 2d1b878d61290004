/* Shapes of one colour each, without soft edges. */
uniform vec2 size; /* of the picture, device pixels */

in vec2 at;
in vec4 colour;

flat out vec4 v_colour;

void
main ()
{
  v_colour = colour;
  gl_Position = vec4 (2.0 * at.x / size.x - 1.0, 1.0 - 2.0 * at.y / size.y,
                      0.0, 1.0);
}
