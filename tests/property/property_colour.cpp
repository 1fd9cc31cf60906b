// Colours of core/implicit/colour.c: never more than the fewest of ColPack, which takes the same
// four orders, on the multiple four-bars, models/, random mechanisms and random matrices.
//
//   property_colour [--seed N] [--from N] [--count N] [--verbose]
#include <ColPack/ColPackHeaders.h>
#include <omp.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "report.h"
#include "subject.h"

extern "C" {
#include "colour.h"
#include "model.h"
#include "pattern.h"
}

namespace
{

int colours(const maggi_sparsity &a, maggi_colour_order order)
{
  maggi_colouring *c;

  if (maggi_colouring_create(&a, order, &c) != MAGGI_OK) std::abort();
  int n = c->ncolour;
  maggi_colouring_free(c);
  return n;
}

int colpack(const maggi_sparsity &a)
{
  static const char *const orders[] = {"NATURAL", "LARGEST_FIRST", "SMALLEST_LAST",
                                       "INCIDENCE_DEGREE"};
  std::vector<int> adr(static_cast<size_t>(a.nrow) + 1);
  std::vector<int> column(static_cast<size_t>(a.coladr[a.ncol]) + 1);
  maggi_sparsity rows = {0, 0, adr.data(), column.data()};
  int least = a.ncol + 1;

  maggi_sparsity_transpose(&a, &rows);
  for (const char *order : orders) {
    ColPack::BipartiteGraphPartialColoringInterface graph(SRC_MEM_CSR, adr.data(), a.nrow, a.ncol,
                                                          column.data());
    graph.PartialDistanceTwoColoring(order, "COLUMN_PARTIAL_DISTANCE_TWO");
    least = std::min(least, graph.GetVertexColorCount());
  }
  return least;
}

void compare(uint64_t seed, const char *what, const maggi_sparsity &a, bool verbose)
{
  int ours = colours(a, MAGGI_COLOUR_BEST), theirs = colpack(a);

  if (verbose)
    std::printf("seed %llu: %s: %d x %d, %d entries, %d colours, ColPack %d\n",
                static_cast<unsigned long long>(seed), what, a.nrow, a.ncol, a.coladr[a.ncol], ours,
                theirs);
  report_true(seed, "never more colours than ColPack", ours <= theirs);
  report_count(ours < theirs ? "fewer than ColPack" : "as many as ColPack");
}

void compare_model(uint64_t seed, const char *what, const maggi_model *m, bool verbose)
{
  maggi_pattern *p;

  if (maggi_pattern_create(&m->topo, &p) != MAGGI_OK) std::abort();
  if (p->n > 0) compare(seed, what, p->J, verbose);
  maggi_pattern_free(p);
}

void check_four_bars(bool verbose)
{
  for (int ny : {1, 4, 7, 20, 60}) {
    maggi_model *m;
    if (maggi_model_multiple_four_bar(ny, 15, &m) != MAGGI_OK) std::abort();
    compare_model(0, ("multiple-four-bar:" + std::to_string(ny) + "x15").c_str(), m, verbose);
    maggi_model_free(m);
  }
}

#ifdef PROPERTY_YAML
void check_models(bool verbose)
{
  for (const auto &file : std::filesystem::directory_iterator(MAGGI_MODELS_DIR)) {
    char message[300];
    maggi_model *m;
    if (file.path().extension() != ".yaml") continue;
    if (!report_true(0, "models are read",
                     maggi_model_load(file.path().c_str(), &m, message, sizeof message) ==
                         MAGGI_OK))
      continue;
    compare_model(0, file.path().filename().c_str(), m, verbose);
    maggi_model_free(m);
  }
}
#endif

void check_mechanism(uint64_t seed, bool verbose)
{
  auto s = std::make_unique<subject>();

  mech_generate(seed, 0, &s->m);
  if (subject_build(s.get(), nullptr))
    compare_model(seed, mech_kind_text(s->m.kind), s->model, verbose);
  subject_free(s.get());
}

void check_matrix(uint64_t seed, bool verbose)
{
  mech_random g = {seed * 31u};
  int nrow = 1 + mech_integer(&g, 40), ncol = 1 + mech_integer(&g, 60);
  double density = mech_uniform(&g, 0.0, mech_integer(&g, 2) ? 0.25 : 0.1);
  std::vector<int> adr{0}, row;

  for (int j = 0; j < ncol; ++j) {
    for (int i = 0; i < nrow; ++i)
      if (mech_uniform(&g, 0.0, 1.0) < density) row.push_back(i);
    adr.push_back(static_cast<int>(row.size()));
  }
  row.push_back(0);
  compare(seed, "matrix", {nrow, ncol, adr.data(), row.data()}, verbose);
}

} // namespace

int main(int argc, char **argv)
{
  report_options options = {1, 1400, 0};

  if (!report_parse(argc, argv, &options)) return 2;
  omp_set_num_threads(1); // or the colours of ColPack are others in each run
  check_four_bars(options.verbose != 0);
#ifdef PROPERTY_YAML
  check_models(options.verbose != 0);
#endif
  for (long i = 0; i < options.count; ++i) {
    check_mechanism(options.from + static_cast<uint64_t>(i), options.verbose != 0);
    check_matrix(options.from + static_cast<uint64_t>(i), options.verbose != 0);
  }
  return report_done("property_colour");
}
