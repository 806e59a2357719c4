/* Warnings about a measured wall that does not suit the sizes that are asked for; see surface.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/surface.h"

void cli_surface_check(const char *name, const char *what, const aspi_profile_report *report,
                       double spacing, double length, double lambda, const cli_list *sizes) {
  if (sizes->least < spacing)
    cli_bad_usage("--dp is %gum; the %s's points are %gum apart and do not resolve it",
                  sizes->least * 1e6, what, spacing * 1e6);
  if (*report->warnings)
    cli_warn("%s: %s", name, report->warnings);
  asp_error doubt;
  if (aspi_sampling_check(sizes->least, spacing, length, lambda, &doubt))
    cli_warn("%s: %s", name, doubt.text);
}
