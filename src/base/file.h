/* Files that are read.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_BASE_FILE_H
#define ASP_BASE_FILE_H

#include "asperity.h"

#include <stdio.h>

/* Opens a file to be read, from its beginning and as often as is wanted: what a pipe holds is
 * copied to a temporary file first. `-` is standard input. NULL on error: ASP_EFILE, ASP_ENOMEM. */
FILE *aspi_file_open(const char *path, asp_error *error);

#endif
