/* A model's draw, inline for the contact, whose stream is in registers. */
#ifndef ASP_SPREAD_DRAW_H
#define ASP_SPREAD_DRAW_H

#include "impact/stream.h"

/* asp_spread_draw */
static inline bool asp_draw(const asp_spread_model *model, const asp_view *view, asp_stream *stream,
                            double *delta) {
  if (model->loop)
    return model->loop(view, stream, delta);
  *delta = model->quantile(view, asp_stream_next(stream));
  return true;
}

#endif
