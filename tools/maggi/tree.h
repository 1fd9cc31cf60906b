/* The tree of bodies, drawn in text. */
#ifndef TOOL_TREE_H
#define TOOL_TREE_H

#include <stdio.h>

#include <maggi/maggi.h>

/* Name of the k-th coordinate of a body, k from 0: NAME, or NAME.1 .. in a compound joint.  Returns
 * its index, or -1 behind the last. */
int tree_coordinate(const maggi_model *m, int body, int k);

/* Draw all bodies below the ground: 0, or -1 without memory. */
int tree_print(const maggi_model *m, FILE *out);

#endif
