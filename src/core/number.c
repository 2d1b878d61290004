#include "number.h"

#include <float.h>
#include <locale.h>
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>

static locale_t c_locale;

static void
make_c_locale (void)
{
  c_locale = newlocale (LC_ALL_MASK, "C", (locale_t)0);
  if (c_locale == (locale_t)0)
    abort ();
}

/* Returns: the thread's locale before, to be given back to uselocale(). */
static locale_t
enter_c_locale (void)
{
  static pthread_once_t once = PTHREAD_ONCE_INIT;

  pthread_once (&once, make_c_locale);
  return uselocale (c_locale);
}

static bool
is_digit (char byte)
{
  return byte >= '0' && byte <= '9';
}

/* Returns: the first byte of @text that is not a digit; sets *@has_value when
 *          one of the digits is not 0. */
static const char *
skip_digits (const char *text, bool *has_value)
{
  for (; is_digit (*text); text += 1)
    *has_value = *has_value || *text != '0';
  return text;
}

static const char *
skip_exponent (const char *text)
{
  const char *end = text + 1;
  bool has_value = false;

  if (*text != 'e' && *text != 'E')
    return text;
  if (*end == '+' || *end == '-')
    end += 1;
  return is_digit (*end) ? skip_digits (end, &has_value) : text;
}

/* Returns: the end of the longest decimal number that starts @text, or NULL;
 *          sets *@has_value when a digit of its mantissa is not 0. */
static const char *
skip_number (const char *text, bool *has_value)
{
  const char *start, *end;

  if (*text == '+' || *text == '-')
    text += 1;
  start = text;
  end = skip_digits (start, has_value);
  if (*end == '.') {
    const char *fraction = end + 1;

    end = skip_digits (fraction, has_value);
    if (fraction == start + 1 && end == fraction)
      return NULL;
  } else if (end == start) {
    return NULL;
  }
  return skip_exponent (end);
}

const char *
number_parse (const char *text, double *number)
{
  bool has_value = false;
  const char *end = skip_number (text, &has_value);
  char *strtod_end;
  locale_t before;

  *number = (double)NAN;
  if (end == NULL)
    return NULL;
  before = enter_c_locale ();
  *number = strtod (text, &strtod_end);
  uselocale (before);
  /* strtod() reads hexadecimal numbers too, from their 0 on. */
  if (strtod_end != end) {
    *number = (double)NAN;
    return NULL;
  }
  if (!isfinite (*number) || (*number == 0 && has_value))
    return NULL;
  return end;
}

void
number_write (double number, char text[NUMBER_ROOM])
{
  const locale_t before = enter_c_locale ();
  /* 15 digits survive the way through a normal double, so fewer need no
   * search: printf() drops their zeros. */
  int digits = fabs (number) < DBL_MIN ? 1 : 15;

  snprintf (text, NUMBER_ROOM, "%.*g", digits, number);
  while (digits < 17 && strtod (text, NULL) != number) {
    digits += 1;
    snprintf (text, NUMBER_ROOM, "%.*g", digits, number);
  }
  uselocale (before);
}

void
number_write_whole (double number, char text[NUMBER_ROOM])
{
  const locale_t before = enter_c_locale ();

  snprintf (text, NUMBER_ROOM, "%.17g", number);
  uselocale (before);
}
