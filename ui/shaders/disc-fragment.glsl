uniform vec4 ground; /* the colour of casings */

flat in vec4 v_colour;
flat in vec4 v_disc;

out vec4 pixel;

void
main ()
{
  float off = length (gl_FragCoord.xy - v_disc.xy);
  vec2 part = clamp (v_disc.zw - off + 0.5, 0.0, 1.0);
  vec4 ink = v_colour * part.x;

  pixel = ground * (part.y * (1.0 - ink.a)) + ink;
}
