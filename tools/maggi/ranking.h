/* Parameters by relevance. */
#ifndef TOOL_RANKING_H
#define TOOL_RANKING_H

/* order: 0 .. n - 1 with falling |first|, then falling |second| (NULL: none), then rising.
 * 0, or -1 without memory. */
int ranking(int n, const double *first, const double *second, int *order);

#endif
