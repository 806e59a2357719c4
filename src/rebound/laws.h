/* The room of the rebound laws: the list of them. A new law is one file that defines its record,
 * and one line here. */
#ifndef ASP_REBOUND_LAWS_H
#define ASP_REBOUND_LAWS_H

#include "asperity.h"

#define ASP_REBOUND_LAWS(X) X(bons) X(constant)

#define ASP_REBOUND_DECLARE(name) extern const asp_rebound_law asp_rebound_##name;
ASP_REBOUND_LAWS(ASP_REBOUND_DECLARE)
#undef ASP_REBOUND_DECLARE

#endif
