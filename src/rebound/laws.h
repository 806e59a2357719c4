/* The list of the rebound laws, and what they share. A new law is one file that defines its record,
 * and one line here. */
#ifndef ASP_REBOUND_LAWS_H
#define ASP_REBOUND_LAWS_H

#include "asperity.h"

#define ASP_REBOUND_LAWS(X) X(bons) X(constant) X(grant_tabakoff) X(table)

#define ASP_REBOUND_DECLARE(name) extern const asp_rebound_law asp_rebound_##name;
ASP_REBOUND_LAWS(ASP_REBOUND_DECLARE)
#undef ASP_REBOUND_DECLARE

/* A rebound that would be faster than the hit is slowed down to its speed, direction kept: measured
 * coefficients may allow it at some angles, energy does not. */
asp_bounce asp_bounce_capped(const asp_hit *hit, double cor_n, double cor_t);

#endif
