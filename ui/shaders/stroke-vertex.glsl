/* All strokes of a drawing: gl-batch.h says what the numbers mean. */
uniform vec2 size; /* of the picture, device pixels */

in vec2 at;
in vec4 colour;
in vec3 local;
in vec4 shape;

out vec4 v_colour;
out vec3 v_local;
flat out vec4 v_shape;

void
main ()
{
  v_colour = colour;
  v_local = local;
  v_shape = shape;
  gl_Position = vec4 (2.0 * at.x / size.x - 1.0, 1.0 - 2.0 * at.y / size.y,
                      0.0, 1.0);
}
