/* Slips at which the formula of a tyre is wanted. */
#ifndef TOOL_POINTS_H
#define TOOL_POINTS_H

enum { POINT_NUMBERS = 5 }; /* kappa, alpha, gamma, fz, vx, as maggi_tyre_forces has them */

typedef struct points {
  double (*slip)[POINT_NUMBERS];
  int number;
} points;

const char *point_name(int k);
const char *point_unit(int k);
int point_find(const char *name); /* in any case of letters; -1 if there is none */

/* Exit status, after a message when it is not STATUS_DONE; points_free in either case.
 *
 * sweep   `at`, or N points from there with one number moved, NAME=FROM:TO:N; NULL: one point
 * read    rows of a CSV file with any of these columns and others; numbers that are `given` or have no
 *         column are those of `at`
 */
int points_sweep(points *p, const double at[POINT_NUMBERS], const char *sweep);
int points_read(points *p, const char *name, const double at[POINT_NUMBERS],
                const int given[POINT_NUMBERS]);
void points_free(points *p);

#endif
