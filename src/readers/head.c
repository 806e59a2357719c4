/* The header of a measured file in text: lengths, units and counts behind keys; see head.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "readers/head.h"
#include "base/number.h"
#include "base/units.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Keys of a header, in English, German and French. Those of SPIP, ESRI and softgauges are as public
 * files have them; Gwyddion's German and French words for the unit were not seen in a file. */
static const char *const keys[] = {
    [ASPI_HEAD_WIDTH] = "width|breite|largeur|x length",
    [ASPI_HEAD_HEIGHT] = "height|h\xC3\xB6he|h\xF6he|hoehe|hauteur|y length",
    [ASPI_HEAD_SPACING] = "spacing|x spacing|pixel size|cellsize|pitch|point spacing|"
                          "xy calibration|x resolution|"
                          "sampling interval|teilung|punktabstand|pas",
    [ASPI_HEAD_Y_SPACING] = "y resolution|y spacing",
    [ASPI_HEAD_UNIT] = "value units|z unit|exported image units|units|unit|werteinheiten|"
                       "\xE5\x8D\x98\xE4\xBD\x8D|\xE5\x8D\x95\xE4\xBD\x8D|" /* Japanese, Chinese */
                       "einheiten der werte|werteinheit|einheit|unit\xC3\xA9s|unit\xE9s",
    [ASPI_HEAD_FACTOR] = "height conversion factor",
    [ASPI_HEAD_COUNT] = "numpoints|number of points|datenanzahl|anzahl punkte|"
                        "nombre de points",
    [ASPI_HEAD_ROWS] = "y pixels|nrows"};

/* Meters in a number and a unit of a line, of a number alone in `unit`, or of a unit alone. */
static double length_in(const char *line, double unit) {
  char text[ASP_PLAIN_MOST], plain[ASP_PLAIN_MOST], *at = text;
  snprintf(text, sizeof text, "%.*s", (int)strcspn(line ? line : "", "\n<"), line ? line : "");
  if (*at == '(' && strchr(at, '='))
    at = strchr(at, '=') + 1;
  if (*at == '[' && strchr(at, ']')) { /* a unit of the key: `X resolution[um],2.0` */
    unit = aspi_unit_meters(at + 1, strcspn(at + 1, "]"));
    at += strcspn(at, "]") + 1;
    at += strspn(at, " \t:=;,\"");
  }
  size_t digits = strspn(at, "+-0123456789.,eE");
  double value = 1;
  aspi_plain(at + digits, plain, sizeof plain);
  double own = aspi_unit_meters(plain, strcspn(plain, "_"));
  bool empty = !*at;
  at[digits] = '\0';
  if (empty || (digits > 0 && aspi_text_number(at, false, &value) != ASP_WORD_NUMBER))
    return 0;
  return value * (own > 0 ? own : digits > 0 ? unit : 0);
}

double aspi_head_length(const aspi_table *t, aspi_head_key key, double unit) {
  return length_in(aspi_table_value(t, keys[key]), unit);
}

/* The last number of a line. */
static double last_number(const char *line) {
  const char *end = line ? line + strcspn(line, "\n") : NULL, *at = end;
  while (at > line && strchr("0123456789.eE+-", at[-1]))
    at--;
  char *behind;
  return at < end ? aspi_number(at, &behind) : NAN;
}

void aspi_head_known(const aspi_table *t, double unit, double step[2], double *height) {
  const char *head = t->header;
  if (strncmp(head, "Wyko ASCII", 10) == 0) {
    int nm = 0;
    sscanf(head + strcspn(head, "0123456789"), "%*d %d", &nm);
    double wave = last_number(aspi_table_value(t, "wavelength")),
           aspect = last_number(aspi_table_value(t, "aspect"));
    *height = 1e-9 * (nm ? 1 : wave / last_number(aspi_table_value(t, "mult")));
    step[0] = last_number(aspi_table_value(t, "pixel size")) * 1e-3;
    step[1] = step[0] * (aspect > 0 ? aspect : 1);
  } else if (strncmp(head, "DSAA", 4) == 0) {
    double v[6]; /* the numbers of columns and rows, the ends of x, those of y */
    char *at = t->header + 4;
    for (int i = 0; i < 6; i++)
      v[i] = aspi_number(at, &at);
    for (int k = 0; k < 2; k++)
      step[k] = (v[3 + 2 * k] - v[2 + 2 * k]) / (v[k] - 1) * unit;
  }
}

size_t aspi_head_count(const aspi_table *t, aspi_head_key key) {
  const char *text = aspi_table_value(t, keys[key]);
  return text ? (size_t)strtoul(text, NULL, 10) : 0;
}
