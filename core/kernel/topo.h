/* The integers of a model: what the kernel loops over.  Nothing here is differentiated.
 *
 * Bodies are numbered from the leaves to the root, parent[i] > i; the ground is row nbody of arrays
 * with nbody + 1 rows.  Compound joints are already chains of one-DOF joints.  Coordinates are
 * numbered in the order of their bodies.  Addresses `..adr` point into the parameter vector p.
 *
 * MAGGI_TOPO_LIST is fixed when the model is compiled.  MAGGI_PLAN_LIST depends on the choice of the
 * independent coordinates and is written by maggi_plan_compile (core/dynamics/plan.c).
 */
#ifndef MAGGI_TOPO_H
#define MAGGI_TOPO_H

/* joint of one expanded body */
enum { MAGGI_ONE_REVOLUTE, MAGGI_ONE_PRISMATIC, MAGGI_ONE_FIXED };

/* where a unit vector comes from: p; a global axis; two vectors across the axis `adr`, the first one
 * leaning on p[aux..] or on the global axis `aux`; the first such vector of the axis p[aux..], leaning
 * on the global axis `lean` and carried over to the axis `adr` by the smallest turn */
enum {
  MAGGI_DIR_PARAMETER,
  MAGGI_DIR_GLOBAL,
  MAGGI_DIR_ACROSS,
  MAGGI_DIR_ACROSS_GLOBAL,
  MAGGI_DIR_NORMAL,
  MAGGI_DIR_NORMAL_GLOBAL,
  MAGGI_DIR_CARRIED
};

/* contributions to the inertia of a body and the entries they have in p */
enum {
  MAGGI_LUMP_RIGID, /* mass, cog, inertia xx yy zz xy xz yz */
  MAGGI_LUMP_BAR,   /* mass, from, to */
  MAGGI_LUMP_POINT, /* mass, point */
  MAGGI_LUMP_ROD_A, /* mass, point_a, point_b: a third of the mass at point_a */
  MAGGI_LUMP_ROD_B  /* the same at point_b */
};

/* building blocks of loop closure, FORMULATION 4 */
enum {
  MAGGI_PRIM_POINT, /* r_a - r_b                       3 rows */
  MAGGI_PRIM_AXIS,  /* u_a - u_b                       3      */
  MAGGI_PRIM_ANGLE, /* u_a.u_b - constant              1      */
  MAGGI_PRIM_PLANE, /* (r_a - r_b).u_b                 1      */
  MAGGI_PRIM_ROD    /* (|r_a - r_b|^2 - l^2) / (2 l)   1      */
};

/* entries of elements in p, from their address */
enum {
  MAGGI_SPRING_K,
  MAGGI_SPRING_L,
  MAGGI_SPRING_C,
  MAGGI_SPRING_SLOPES
}; /* then c1..c4 v11 v22 */
enum { MAGGI_JSPRING_K, MAGGI_JSPRING_C, MAGGI_JSPRING_REST, MAGGI_JSPRING_PRELOAD };
enum { MAGGI_DRAG_RHO, MAGGI_DRAG_C, MAGGI_DRAG_AREA, MAGGI_DRAG_LOW, MAGGI_DRAG_WIND };
enum {
  MAGGI_DRIVER_PREVIEW,
  MAGGI_DRIVER_GAIN,
  MAGGI_DRIVER_FEEDFORWARD,
  MAGGI_DRIVER_LIMIT,
  MAGGI_DRIVER_STIFFNESS,
  MAGGI_DRIVER_DAMPING
};

/* columns of paths: length of the polyline; elimination; second derivatives of x, y and speed, and what
 * their elimination needs */
enum {
  MAGGI_PATH_S,
  MAGGI_PATH_W,
  MAGGI_PATH_X,
  MAGGI_PATH_XE,
  MAGGI_PATH_Y,
  MAGGI_PATH_YE,
  MAGGI_PATH_V,
  MAGGI_PATH_VE
};
enum { MAGGI_SPEED_TARGET, MAGGI_SPEED_GAIN, MAGGI_SPEED_TORQUE, MAGGI_SPEED_LOW };
enum {
  MAGGI_BUMPS_RADIUS,
  MAGGI_BUMPS_HEIGHT,
  MAGGI_BUMPS_FIRST,
  MAGGI_BUMPS_SPACING,
  MAGGI_BUMPS_FILLET
};

/* what is known of a wheel on its road; Fz as its spring has it, negative in the air */
enum {
  MAGGI_SLIP_KAPPA,
  MAGGI_SLIP_TAN_ALPHA,
  MAGGI_SLIP_GAMMA,
  MAGGI_SLIP_FZ,
  MAGGI_SLIP_VX,
  MAGGI_SLIP_RADIUS,  /* loaded */
  MAGGI_SLIP_ROLLING, /* Re */
  MAGGI_SLIP_NUMBERS
};

/* what sensors are made of: accelerations, multipliers of loops */
enum { MAGGI_NEED_ACCELERATION = 1, MAGGI_NEED_MULTIPLIER = 2 };

#define MAGGI_TOPO_SIZES(X)                                                                        \
  X(nbody, "expanded bodies without the ground")                                                   \
  X(nq, "coordinates")                                                                             \
  X(np, "parameters")                                                                              \
  X(nlump, "contributions to inertia")                                                             \
  X(nmassive, "bodies with inertia")                                                               \
  X(npoint, "body points that the dynamics needs, then those of sensors")                          \
  X(npointdyn, "the first of these")                                                               \
  X(ndir, "body directions")                                                                       \
  X(nprim, "building blocks of loop closure")                                                      \
  X(nrow, "loop equations")                                                                        \
  X(nloop, "loops, rods included")                                                                 \
  X(npath, "entries of the paths of all loops")                                                    \
  X(nrod, "rods with mass")                                                                        \
  X(nrodjac, "coordinates that move ends of rods with mass")                                       \
  X(nrodpair, "products of these in the mass matrix")                                              \
  X(npair, "entries of the mass matrix of the tree, upper half, and of rods")                      \
  X(ntreepair, "of which of the tree")                                                             \
  X(nspring, "springs between points")                                                             \
  X(njspring, "springs on coordinates")                                                            \
  X(nforce, "loads")                                                                               \
  X(nspeed, "controllers of speed")                                                                \
  X(nspeedq, "coordinates on which they act")                                                      \
  X(ndriver, "drivers")                                                                            \
  X(npath0, "points of all their paths")                                                           \
  X(ntyre, "tyres: sets of numbers")                                                               \
  X(nroad, "roads")                                                                                \
  X(nwheel, "wheels")                                                                              \
  X(nfun, "functions of time")                                                                     \
  X(nspline, "second derivatives of all splines")                                                  \
  X(nguide, "guided coordinates")                                                                  \
  X(nbase, "prismatic joints that carry the whole model")                                          \
  X(nsensor, "sensors")                                                                            \
  X(nterm, "terms of sensors that are sums of others")                                             \
  X(nfilter, "filters")                                                                            \
  X(nstate, "states of filters")

#define MAGGI_TOPO_LIST(X)                                                                         \
  X(parent, nbody, "parent body")                                                                  \
  X(joint, nbody, "MAGGI_ONE_..")                                                                  \
  X(qid, nbody, "coordinate of the joint, -1 if fixed")                                            \
  X(jdirkind, nbody, "MAGGI_DIR_.. of the axis")                                                   \
  X(jdiradr, nbody, "its address")                                                                 \
  X(jdiraux, nbody, "its second address, or a global axis")                                        \
  X(jpointadr, nbody, "address of the joint point")                                                \
  X(qbody, nq, "body of a coordinate")                                                             \
  X(qguide, nq, "function that guides the coordinate, -1 if none")                                 \
  X(lumpkind, nlump, "MAGGI_LUMP_..")                                                              \
  X(lumpbody, nlump, "body")                                                                       \
  X(lumpadr, nlump, "address")                                                                     \
  X(massive, nmassive, "bodies with inertia")                                                      \
  X(pointbody, npoint, "body, nbody for the ground")                                               \
  X(pointadr, npoint, "address")                                                                   \
  X(pointadr2, npoint, "address of a second one, the point being in the middle, -1 if none")       \
  X(dirbody, ndir, "body")                                                                         \
  X(dirkind, ndir, "MAGGI_DIR_..")                                                                 \
  X(diradr, ndir, "address")                                                                       \
  X(diraux, ndir, "second address, or a global axis")                                              \
  X(dirlean, ndir, "global axis of MAGGI_DIR_CARRIED")                                             \
  X(primkind, nprim, "MAGGI_PRIM_..")                                                              \
  X(primloop, nprim, "loop")                                                                       \
  X(primpa, nprim, "point on body a")                                                              \
  X(primpb, nprim, "point on body b")                                                              \
  X(primda, nprim, "direction on body a")                                                          \
  X(primdb, nprim, "direction on body b")                                                          \
  X(primadr, nprim, "address of a given length, -1: as drawn; -2: right angle")                    \
  X(primrow, nprim, "first loop equation")                                                         \
  X(primba, nprim, "body a")                                                                       \
  X(primbb, nprim, "body b")                                                                       \
  X(pathadr, nloop1, "first entry of the path of a loop; side a from the root, then side b")       \
  X(pathq, npath, "coordinate")                                                                    \
  X(pathside, npath, "0: moves body a, 1: moves body b")                                           \
  X(loopcommon, nloop, "lowest body that carries both sides")                                      \
  X(rodadr, nrod, "address of the mass")                                                           \
  X(rodpa, nrod, "point a")                                                                        \
  X(rodpb, nrod, "point b")                                                                        \
  X(rodcommon, nrod, "lowest body that carries both ends")                                         \
  X(rodjacpoint, nrodjac, "end point")                                                             \
  X(rodjacq, nrodjac, "coordinate that moves it")                                                  \
  X(rodjacadr, nrodjac, "address of the mass of the rod, -1 at its end b")                         \
  X(rodjacother, nrodjac, "at end a: first entry at end b that it meets")                          \
  X(rodjacnum, nrodjac, "their number, 0 at end b")                                                \
  X(rodpairm, nrodpair, "entry of the mass matrix")                                                \
  X(pairadr, nq1, "first pair of a coordinate: itself, then its ancestors")                        \
  X(pairi, npair, "lower coordinate of a pair")                                                    \
  X(pairj, npair, "its ancestor, or the other one of a rod")                                       \
  X(springpa, nspring, "point a")                                                                  \
  X(springpb, nspring, "point b")                                                                  \
  X(springadr, nspring, "address")                                                                 \
  X(springpreload, nspring, "1: preload and length as drawn, 0: free length")                      \
  X(springslopes, nspring, "1: with the four-slope damper")                                        \
  X(jspringq, njspring, "coordinate")                                                              \
  X(jspringq2, njspring, "second coordinate, -1 if none")                                          \
  X(jspringadr, njspring, "address")                                                               \
  X(forcekind, nforce, "maggi_force_type")                                                         \
  X(forcebody, nforce, "body")                                                                     \
  X(forcereaction, nforce, "body that takes the reaction, nbody for the ground")                   \
  X(forcepoint, nforce, "point, -1 if none")                                                       \
  X(forceq, nforce, "coordinate, -1 if none")                                                      \
  X(forcefun, nforce, "function, -1: constant")                                                    \
  X(forceadr, nforce, "address of the value, or of the numbers of a drag")                         \
  X(speedlinear, nspeed, "1: torque in proportion to the error, 0: to its square")                 \
  X(speeddriver, nspeed, "driver whose speed it keeps, -1 if none")                                \
  X(speedpoint, nspeed, "point")                                                                   \
  X(speedfun, nspeed, "function, factor on the target, -1: constant")                              \
  X(speedadr, nspeed, "address: MAGGI_SPEED_..")                                                   \
  X(speedheld, nspeed, "1: no torque")                                                             \
  X(speedqadr, nspeed, "first entry of speedq")                                                    \
  X(speedqnum, nspeed, "number of entries")                                                        \
  X(speedq, nspeedq, "coordinate")                                                                 \
  X(driverpoint, ndriver, "point that is to follow the path")                                      \
  X(driverorigin, ndriver, "point on the ground from which the path counts")                       \
  X(driverq, ndriver, "coordinate that steers")                                                    \
  X(driveradr, ndriver, "address: MAGGI_DRIVER_..")                                                \
  X(driverpath, ndriver, "address of the points: all x, all y, all speeds")                        \
  X(driverspeeds, ndriver, "1: with speeds")                                                       \
  X(drivern, ndriver, "number of points")                                                          \
  X(driverrow, ndriver, "first row of path0")                                                      \
  X(driverheld, ndriver, "1: no torque")                                                           \
  X(tyreadr, ntyre, "address: MAGGI_TYRE_..")                                                      \
  X(roadkind, nroad, "maggi_road_type")                                                            \
  X(roadadr, nroad, "address of its numbers")                                                      \
  X(roadn, nroad, "number of bumps or points")                                                     \
  X(roadspline, nroad, "first second derivative of a profile")                                     \
  X(roadpoint, nroad, "point on the ground from which its height counts")                          \
  X(wheelbody, nwheel, "body that turns")                                                          \
  X(wheelcarrier, nwheel, "body on which it turns")                                                \
  X(wheelpoint, nwheel, "centre")                                                                  \
  X(wheelaxis, nwheel, "address of the axis")                                                      \
  X(wheeltyre, nwheel, "tyre")                                                                     \
  X(wheelmirror, nwheel, "1: on the other side than the tyre was measured for")                    \
  X(wheelroad, nwheel, "road")                                                                     \
  X(wheelgrip, nwheel, "0: no force but that of its vertical spring")                              \
  X(funkind, nfun, "maggi_function_type")                                                          \
  X(funadr, nfun, "address: times then values, or the scalars")                                    \
  X(funn, nfun, "number of points or coefficients")                                                \
  X(funspline, nfun, "first second derivative of a spline")                                        \
  X(funheld, nfun, "1: its value alone, rates are zero")                                           \
  X(base, nbase, "bodies of the base chain")                                                       \
  X(sensorkind, nsensor, "maggi_sensor_type")                                                      \
  X(sensorbody, nsensor, "body")                                                                   \
  X(sensorpoint, nsensor, "point")                                                                 \
  X(sensorelement, nsensor,                                                                        \
    "spring, spring on coordinates, wheel, building block of a rod, or first term")                \
  X(sensoradr, nsensor, "address of its numbers, or of the weights of a sum")                      \
  X(sensorterms, nsensor, "number of terms")                                                       \
  X(sensorneed, nsensor, "MAGGI_NEED_.., besides positions and velocities")                        \
  X(termsensor, nterm, "sensor, before the sum")                                                   \
  X(termcolumn, nterm, "which of its numbers")                                                     \
  X(filtersensor, nfilter, "sensor")                                                               \
  X(filtercolumn, nfilter, "its column: 0, 1, 2")                                                  \
  X(filterstate, nfilter, "first state")                                                           \
  X(filteradr, nfilter, "address of f1, then f2")                                                  \
  X(filterf3, nfilter, "address of f3, -1 if infinite")                                            \
  X(filterf4, nfilter, "address of f4, q4, -1 if infinite: without transition")                    \
  X(filterf5, nfilter, "address of f5, q5, f6, q6, -1 if infinite: without step")                  \
  X(filtergain, nfilter, "address of the gain")

#define MAGGI_PLAN_SIZES(X)                                                                        \
  X(nind, "independent coordinates")                                                               \
  X(ndep, "dependent coordinates, the rank of the loop equations")                                 \
  X(ncol, "columns of R_z: independent, then guided coordinates")                                  \
  X(stride, "length of a row of columns, a multiple of 8")                                         \
  X(nisland, "islands of loops, in the order in which they are solved")                            \
  X(nvrow, "rows of velocities by columns; row 0 is at rest")                                      \
  X(nvop, "their updates")                                                                         \
  X(nent, "entries of Phi_d")                                                                      \
  X(nphi, "numbers in the dense blocks of Phi_d")                                                  \
  X(nchol, "numbers in their factors")                                                             \
  X(nii, "pairs independent-independent")                                                          \
  X(nid, "pairs independent-dependent")                                                            \
  X(ndd, "pairs dependent-dependent")

#define MAGGI_PLAN_LIST(X)                                                                         \
  X(col, nq, "column of a coordinate, -1 if dependent")                                            \
  X(colq, nq, "coordinate of a column")                                                            \
  X(rbeg, nq, "first nonzero column of the row of R_z of a coordinate")                            \
  X(rend, nq, "one after the last")                                                                \
  X(dep, nq, "dependent coordinates by island")                                                    \
  X(isldep, nloop1, "first in dep of an island")                                                   \
  X(islprim, nloop1, "first in primorder of an island")                                            \
  X(islrow, nloop1, "first row of an island")                                                      \
  X(islvop, nloop1, "first update before an island")                                               \
  X(islent, nloop1, "first entry of an island")                                                    \
  X(islphi, nloop1, "address of its block of Phi_d, rows by dependents")                           \
  X(islchol, nloop1, "address of its factor")                                                      \
  X(islbeg, nloop1, "first column of an island")                                                   \
  X(islend, nloop1, "one after the last")                                                          \
  X(primorder, nprim, "building blocks by island")                                                 \
  X(primy, nprim, "first row of a block in the order of islands")                                  \
  X(primva, nprim, "velocity row of its body a without the dependents of the island")              \
  X(primvb, nprim, "the same of body b")                                                           \
  X(first, nq, "first nonzero row of a column of the reduced mass matrix")                         \
  X(zbeg, nq, "first column of a row of M R_z of a dependent coordinate")                          \
  X(zend, nq, "one after the last")                                                                \
  X(vrowbeg, nvrow, "first column of a velocity row")                                              \
  X(vrowend, nvrow, "one after the last")                                                          \
  X(vopdst, nvop, "row = row vopsrc + b_i R_i, i = vopq")                                          \
  X(vopsrc, nvop, "")                                                                              \
  X(vopq, nvop, "")                                                                                \
  X(entprim, nent, "building block of an entry of Phi_d")                                          \
  X(entside, nent, "0: coordinate moves body a, 1: body b")                                        \
  X(entq, nent, "coordinate")                                                                      \
  X(entadr, nent, "address of its first row")                                                      \
  X(entstep, nent, "from one row to the next")                                                     \
  X(iipair, npair, "pair of two columns")                                                          \
  X(idpair, npair, "pair of a dependent coordinate and a column")                                  \
  X(iddep, npair, "the dependent coordinate")                                                      \
  X(idcol, npair, "the column")                                                                    \
  X(iirow, npair, "the smaller column")                                                            \
  X(iicol, npair, "the larger one")                                                                \
  X(ddadr, nq1, "first pair of two dependents for each row of M R_z, in the order of dep")         \
  X(ddpair, npair, "pair of two dependent coordinates")                                            \
  X(ddsrc, npair, "row of R_z that it multiplies")

typedef struct maggi_topo {
#define X(name, text) int name;
  MAGGI_TOPO_SIZES(X)
  MAGGI_PLAN_SIZES(X)
#undef X
  int nloop1; /* nloop + 1 */
  int nq1;    /* nq + 1 */
#define X(name, size, text) int *name;
  MAGGI_TOPO_LIST(X)
  MAGGI_PLAN_LIST(X)
#undef X
} maggi_topo;

#endif
