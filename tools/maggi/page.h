/* Pages, which scripts/report writes. */
#ifndef TOOL_PAGE_H
#define TOOL_PAGE_H

/* Whether it can write `out`; write it from the tables of n runs (out NULL: beside the first one, title
 * NULL: names of the models; width of the vehicle in meters as text, NULL: of its tyres).  Exit status,
 * after a message when it is not STATUS_DONE. */
int page_check(const char *out);
int page_draw(int n, const char *const *table, const char *out, const char *title,
              const char *width);

#endif
