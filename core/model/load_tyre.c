/* Tyres, their property files, roads and wheels.
 *
 * A property file (.tir) is lines: `[SECTION]`, `KEY = value`, comments from $ or ! on, and tables, which
 * begin with a line in braces or parentheses and end with the section.  Keys are looked up in any section
 * and in any case of letters.  What is not in MAGGI_TYRE_LIST is not needed in steady state and is passed
 * over; what the force needs and the file has not is an error, as is a key that is there twice.
 */
#include "load_build.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LINE_MAX_CHARS = 1000, KEY_MAX_CHARS = 60 };

typedef struct tir {
  const load_error *error;
  maggi_tyre_def *def;
  size_t line;
  int in_table;
  size_t given[MAGGI_TYRE_NUMBERS]; /* line, 0: not in the file */
  double length, force, time;       /* units of the file in SI */
} tir;

typedef struct unit {
  const char *word;
  double si;
} unit;

static const unit lengths[] = {
    {"meter", 1.0},       {"m", 1.0},     {"millimeter", 1e-3}, {"mm", 1e-3},     {"cm", 1e-2},
    {"centimeter", 1e-2}, {"km", 1e3},    {"kilometer", 1e3},   {"inch", 0.0254}, {"in", 0.0254},
    {"foot", 0.3048},     {"ft", 0.3048}, {NULL, 0.0}};
static const unit forces[] = {{"newton", 1.0},
                              {"n", 1.0},
                              {"kilonewton", 1e3},
                              {"knewton", 1e3},
                              {"kn", 1e3},
                              {"pound_force", 4.4482216152605},
                              {"lbf", 4.4482216152605},
                              {"kilogram_force", 9.80665},
                              {"kg_force", 9.80665},
                              {"kgf", 9.80665},
                              {NULL, 0.0}};
static const unit times[] = {
    {"second", 1.0},       {"seconds", 1.0}, {"sec", 1.0}, {"s", 1.0},
    {"millisecond", 1e-3}, {"msec", 1e-3},   {"ms", 1e-3}, {"minute", 60.0},
    {"min", 60.0},         {"hour", 3600.0}, {NULL, 0.0}};
static const unit angles[] = {{"radian", 1.0}, {"radians", 1.0}, {"rad", 1.0}, {NULL, 0.0}};

static int is_word(const char *text, const char *word)
{
  while (*text && tolower((unsigned char)*text) == *word) ++text, ++word;
  return *text == '\0' && *word == '\0';
}

/* ---------------------------------------------------------------------------------------- values */

static maggi_status read_unit(const tir *t, const char *key, const char *value, const unit *units,
                              double *si)
{
  char all[200] = "";
  size_t n = 0;
  int i;

  for (i = 0; units[i].word; ++i) {
    if (is_word(value, units[i].word)) {
      *si = units[i].si;
      return MAGGI_OK;
    }
    n += (size_t)snprintf(all + n, sizeof all - n, "%s%s", i ? ", " : "", units[i].word);
  }
  return maggi_load_fail(t->error, t->line, "%s: unit \"%.40s\" is none of %s", key, value, all);
}

static maggi_status read_number(tir *t, int number, const char *key, const char *value)
{
  if (t->given[number])
    return maggi_load_fail(t->error, t->line, "\"%s\" is here twice, first in line %zu", key,
                           t->given[number]);
  if (!maggi_load_is_decimal(value))
    return maggi_load_fail(t->error, t->line, "%s: \"%.40s\" is not a number", key, value);
  t->given[number] = t->line;
  t->def->value[number] = strtod(value, NULL);
  if (!isfinite(t->def->value[number]))
    return maggi_load_fail(t->error, t->line, "%s: \"%.40s\" is too large", key, value);
  return MAGGI_OK;
}

static maggi_status read_value(tir *t, const char *key, const char *value)
{
  static const char *const keys[MAGGI_TYRE_NUMBERS] = {
#define X(name, key, unit, value, bound) #name,
      MAGGI_TYRE_LIST(X)
#undef X
  };
  int i;

  for (i = 0; i < MAGGI_TYRE_NUMBERS; ++i)
    if (strcmp(key, keys[i]) == 0) return read_number(t, i, key, value);
  if (strcmp(key, "LENGTH") == 0) return read_unit(t, key, value, lengths, &t->length);
  if (strcmp(key, "FORCE") == 0) return read_unit(t, key, value, forces, &t->force);
  if (strcmp(key, "TIME") == 0) return read_unit(t, key, value, times, &t->time);
  if (strcmp(key, "ANGLE") == 0) return read_unit(t, key, value, angles, &(double){0.0});
  if (strcmp(key, "PROPERTY_FILE_FORMAT") == 0 && !is_word(value, "pac2002"))
    return maggi_load_fail(t->error, t->line, "%s: \"%.40s\" is not PAC2002", key, value);
  if (strcmp(key, "TYRESIDE") == 0) {
    if (!is_word(value, "left") && !is_word(value, "right"))
      return maggi_load_fail(t->error, t->line, "%s: \"%.40s\" is none of LEFT, RIGHT", key, value);
    t->def->side = is_word(value, "right") ? MAGGI_RIGHT : MAGGI_LEFT;
  }
  return MAGGI_OK;
}

/* ----------------------------------------------------------------------------------------- lines */

static char *trim(char *text)
{
  char *end;

  while (isspace((unsigned char)*text)) ++text;
  end = text + strlen(text);
  while (end > text && isspace((unsigned char)end[-1])) --end;
  *end = '\0';
  return text;
}

/* up to a comment that does not stand in quotes; then the quotes themselves */
static char *without_comment(char *text)
{
  char quote = '\0', *c;

  for (c = text; *c; ++c) {
    if (quote) {
      if (*c == quote) quote = '\0';
    } else if (*c == '\'' || *c == '"') {
      quote = *c;
    } else if (*c == '$' || *c == '!') {
      *c = '\0';
      break;
    }
  }
  return trim(text);
}

static char *unquoted(char *text)
{
  size_t n = strlen(text);

  if (n < 2 || (*text != '\'' && *text != '"') || text[n - 1] != *text) return text;
  text[n - 1] = '\0';
  return trim(text + 1);
}

static maggi_status read_line(tir *t, char *text)
{
  char *key, *value, *c;

  text = without_comment(text);
  if (*text == '\0') return MAGGI_OK;
  if (*text == '[') {
    t->in_table = 0;
    if (text[strlen(text) - 1] == ']') return MAGGI_OK;
    return maggi_load_fail(t->error, t->line, "\"%.40s\": a section ends with ]", text);
  }
  if (*text == '{' || *text == '(') t->in_table = 1;
  if (t->in_table) return MAGGI_OK;
  value = strchr(text, '=');
  if (!value)
    return maggi_load_fail(t->error, t->line, "\"%.40s\" is neither [SECTION] nor KEY = value",
                           text);
  *value++ = '\0';
  key = trim(text);
  if (*key == '\0' || strlen(key) > KEY_MAX_CHARS)
    return maggi_load_fail(t->error, t->line, "\"%.40s\" is no key", key);
  for (c = key; *c; ++c) *c = (char)toupper((unsigned char)*c);
  return read_value(t, key, unquoted(trim(value)));
}

static maggi_status check_given(const tir *t)
{
  int i;
  static const char *const keys[MAGGI_TYRE_NUMBERS] = {
#define X(name, key, unit, value, bound) #name,
      MAGGI_TYRE_LIST(X)
#undef X
  };

  for (i = 0; i < MAGGI_TYRE_NUMBERS; ++i)
    if (isnan(t->def->value[i])) return maggi_load_fail(t->error, 0, "key %s is missing", keys[i]);
  return MAGGI_OK;
}

static void convert(const tir *t)
{
  double *x = t->def->value;

  if (t->given[MAGGI_TYRE_FNOMIN]) x[MAGGI_TYRE_FNOMIN] *= t->force;
  if (t->given[MAGGI_TYRE_UNLOADED_RADIUS]) x[MAGGI_TYRE_UNLOADED_RADIUS] *= t->length;
  if (t->given[MAGGI_TYRE_VERTICAL_STIFFNESS])
    x[MAGGI_TYRE_VERTICAL_STIFFNESS] *= t->force / t->length;
  if (t->given[MAGGI_TYRE_VERTICAL_DAMPING])
    x[MAGGI_TYRE_VERTICAL_DAMPING] *= t->force * t->time / t->length;
  if (t->given[MAGGI_TYRE_LONGVL]) x[MAGGI_TYRE_LONGVL] *= t->length / t->time;
  if (t->given[MAGGI_TYRE_VXLOW]) x[MAGGI_TYRE_VXLOW] *= t->length / t->time;
}

maggi_status maggi_load_tir(const load_error *e, const char *bytes, size_t n, maggi_tyre_def *def)
{
  tir t = {.error = e, .def = def, .length = 1.0, .force = 1.0, .time = 1.0};
  const char *p = bytes, *end = bytes + n, *stop;
  char text[LINE_MAX_CHARS + 1];
  maggi_status status = MAGGI_OK;
  size_t length;

  if (n >= 3 && memcmp(p, "\xef\xbb\xbf", 3) == 0) p += 3;
  while (p < end && status == MAGGI_OK) {
    ++t.line;
    stop = memchr(p, '\n', (size_t)(end - p));
    if (!stop) stop = end;
    length = (size_t)(stop - p);
    if (length > LINE_MAX_CHARS)
      return maggi_load_fail(e, t.line, "a line has more than %d characters", LINE_MAX_CHARS);
    if (memchr(p, '\0', length)) return maggi_load_fail(e, t.line, "a NUL character");
    memcpy(text, p, length);
    text[length] = '\0';
    status = read_line(&t, text);
    p = stop < end ? stop + 1 : end;
  }
  if (status == MAGGI_OK) status = check_given(&t);
  if (status == MAGGI_OK) convert(&t);
  return status;
}

/* --------------------------------------------------------------------------------------- entries */

/* what is wrong in the property file has its own FILE:LINE: */
static maggi_status read_file(const load_build *b, const load_tyre *tyre, maggi_tyre_def *def)
{
  char *path = maggi_load_path(b, tyre->file), *bytes = NULL, text[400] = "";
  const load_error in_file = {path, text, sizeof text};
  maggi_status status = MAGGI_E_MEMORY;
  size_t n;

  if (path) status = maggi_load_read(&in_file, &bytes, &n);
  if (status == MAGGI_OK) status = maggi_load_tir(&in_file, bytes, n, def);
  if (status == MAGGI_E_FILE)
    maggi_load_fail_at(b, ".file", "%s", text);
  else if (status == MAGGI_E_MEMORY)
    maggi_load_fail(b->error, 0, "out of memory");
  else if (status != MAGGI_OK && b->error->message && b->error->nmessage)
    snprintf(b->error->message, b->error->nmessage, "%s", text);
  free(bytes);
  free(path);
  return status;
}

maggi_status maggi_load_tyre(const load_build *b, const load_tyre *tyre)
{
  maggi_tyre_def def;
  maggi_status status;

  maggi_tyre_def_init(&def);
  status = read_file(b, tyre, &def);
  if (status) return status;
  def.name = tyre->name;
  if (tyre->low_camber) def.value[MAGGI_TYRE_LOW_CAMBER] = *tyre->low_camber;
  if (tyre->low_speed) def.value[MAGGI_TYRE_LOW_SPEED] = *tyre->low_speed;
  return maggi_load_added(b, "", maggi_builder_tyre(b->builder, &def));
}

static const char *road_word(int i)
{
  return maggi_road_type_name((maggi_road_type)i);
}

static const char *side_word(int i)
{
  static const char *const words[] = {"left", "right"};

  return i >= 0 && i < 2 ? words[i] : NULL;
}

static int find_side(const char *word)
{
  int i;

  for (i = 0; i < 2; ++i)
    if (strcmp(word, side_word(i)) == 0) return i;
  return -1;
}

static const load_words road_words = {road_word, maggi_road_type_find};
static const load_words side_words = {side_word, find_side};

maggi_status maggi_load_road(const load_build *b, const load_road *road)
{
  /* slope; amplitude, wavelength; radius, height, first, spacing, number, fillet; x, z */
  static const char *const rules[MAGGI_ROAD_TYPE_COUNT] = {[MAGGI_ROAD_FLAT] = "o",
                                                           [MAGGI_ROAD_SINE] = "-rr",
                                                           [MAGGI_ROAD_BUMPS] = "---rrrooo",
                                                           [MAGGI_ROAD_PROFILE] = "---------rr"};
  const load_key keys[] = {{"slope", road->slope != NULL},
                           {"amplitude", road->amplitude != NULL},
                           {"wavelength", road->wavelength != NULL},
                           {"radius", road->radius != NULL},
                           {"height", road->height != NULL},
                           {"first", road->first != NULL},
                           {"spacing", road->spacing != NULL},
                           {"number", road->number != NULL},
                           {"fillet", road->fillet != NULL},
                           {"x", road->x != NULL},
                           {"z", road->z != NULL},
                           {NULL, 0}};
  maggi_road_def def;
  maggi_status status;
  int type;

  maggi_road_def_init(&def);
  status = maggi_load_word(b, ".type", road->type, &road_words, &type);
  if (status == MAGGI_OK) status = maggi_load_keys(b, "", road->type, rules[type], keys);
  if (status) return status;
  if (road->x_count != road->z_count)
    return maggi_load_fail_at(b, ".z", "%u heights for %u points", road->z_count, road->x_count);
  if (road->number) {
    if (!(*road->number >= 1.0 && *road->number <= 1e6) || *road->number != floor(*road->number))
      return maggi_load_fail_at(b, ".number", "%g is not a number of bumps", *road->number);
    def.number = (int)*road->number;
  }
  def.name = road->name;
  def.type = (maggi_road_type)type;
  maggi_load_copy3(def.point, road->point);
  if (road->slope) def.slope = *road->slope;
  if (road->amplitude) def.amplitude = *road->amplitude;
  if (road->wavelength) def.wavelength = *road->wavelength;
  if (road->radius) def.radius = *road->radius;
  if (road->height) def.height = *road->height;
  if (road->first) def.first = *road->first;
  if (road->spacing) def.spacing = *road->spacing;
  if (road->fillet) def.fillet = *road->fillet;
  if (road->x) {
    def.x = road->x;
    def.z = road->z;
    def.number = (int)road->x_count;
  }
  return maggi_load_added(b, "", maggi_builder_road(b->builder, &def));
}

maggi_status maggi_load_wheel(const load_build *b, const load_wheel *wheel)
{
  maggi_wheel_def def;
  maggi_status status;
  int side;

  maggi_wheel_def_init(&def);
  status = maggi_load_word(b, ".side", wheel->side, &side_words, &side);
  if (status) return status;
  def.name = wheel->name;
  def.body = wheel->body;
  def.carrier = wheel->carrier;
  def.tyre = wheel->tyre;
  def.road = wheel->road;
  def.side = (maggi_side)side;
  maggi_load_copy3(def.point, wheel->point);
  maggi_load_copy3(def.axis, wheel->axis);
  return maggi_load_added(b, "", maggi_builder_wheel(b->builder, &def));
}
