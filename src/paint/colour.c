#include "theme.h"

#include <math.h>

#define TURN 6.28318530717958647692

static double
clamp (double value)
{
  return fmin (fmax (value, 0), 1);
}

static double
linear_of (double value)
{
  return value <= 0.04045 ? value / 12.92 : pow ((value + 0.055) / 1.055, 2.4);
}

static double
encoded (double linear)
{
  const double value = clamp (linear);

  return value <= 0.0031308 ? 12.92 * value
                            : 1.055 * pow (value, 1 / 2.4) - 0.055;
}

static double
luminance (Colour colour)
{
  return 0.2126 * linear_of (colour.red) + 0.7152 * linear_of (colour.green)
         + 0.0722 * linear_of (colour.blue);
}

double
colour_contrast (Colour a, Colour b)
{
  const double light = fmax (luminance (a), luminance (b));
  const double dark = fmin (luminance (a), luminance (b));

  return (light + 0.05) / (dark + 0.05);
}

Colour
colour_mix (Colour a, Colour b, double part)
{
  return (Colour){ a.red + part * (b.red - a.red),
                   a.green + part * (b.green - a.green),
                   a.blue + part * (b.blue - a.blue), a.alpha };
}

Colour
colour_oklch (double lightness, double chroma, double hue)
{
  const double a = chroma * cos (TURN * hue), b = chroma * sin (TURN * hue);
  const double l = pow (lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = pow (lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = pow (lightness - 0.0894841775 * a - 1.2914855480 * b, 3);

  return (Colour){
    encoded (4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
    encoded (-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
    encoded (-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s), 1
  };
}
