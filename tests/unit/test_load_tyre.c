/* core/model/load_tyre.c: property files as users have them, and what is wrong with them. */
#include "fixture.h"
#include "load_file.h"

static const char least[] = "[VERTICAL]\n"
                            "FNOMIN = 35000\n"
                            "VERTICAL_STIFFNESS = 7e5\n"
                            "[DIMENSION]\n"
                            "UNLOADED_RADIUS = 0.5\n"
                            "[LONGITUDINAL_COEFFICIENTS]\n"
                            "PCX1 = 1.7\nPDX1 = 0.8\nPKX1 = 15\n"
                            "[LATERAL_COEFFICIENTS]\n"
                            "PCY1 = 1.6\nPDY1 = 0.7\nPKY1 = -10\nPKY2 = 3.3\n";

static maggi_status read(const char *text, maggi_tyre_def *def, char message[400])
{
  const load_error e = {"t.tir", message, 400};

  message[0] = '\0';
  maggi_tyre_def_init(def);
  return maggi_load_tir(&e, text, strlen(text), def);
}

/* the text after the least file, or, without it, instead of it */
static maggi_status read_more(const char *more, maggi_tyre_def *def, char message[400])
{
  char text[4000];

  snprintf(text, sizeof text, "%s%s", least, more);
  return read(text, def, message);
}

static void test_defaults(void)
{
  maggi_tyre_def def;
  char message[400];

  CHECK(read(least, &def, message) == MAGGI_OK);
  CHECK_TEXT(message, "");
  CHECK(def.side == MAGGI_LEFT);
  CHECK(def.value[MAGGI_TYRE_FNOMIN] == 35000.0);
  CHECK(def.value[MAGGI_TYRE_PKY1] == -10.0);
  CHECK(def.value[MAGGI_TYRE_LMUX] == 1.0);
  CHECK(def.value[MAGGI_TYRE_PEX1] == 0.0);
  CHECK(def.value[MAGGI_TYRE_LONGVL] == 16.7);
}

/* comments, tables, any case, line ends, quotes, keys that are not needed */
static void test_manners(void)
{
  maggi_tyre_def def;
  char message[400];

  CHECK(read_more("$ a comment = 3\n! another\n   \r\n\tpex1\t=\t-.5e-1   $ of Ex = 3\r\n"
                  "[SHAPE]\n{radial width}\n 1.0 0.0\n 1.0 0.4\n$---\n[MODEL]\n"
                  "TYRESIDE = 'Right' ! side\nPROPERTY_FILE_FORMAT='PAC2002'\nUSE_MODE = 14\n"
                  "FUNCTION_NAME = 'TYR$902'\n(COMMENTS)\n{comment_string}\nanything at all\n"
                  "[NEW]\nPTX1 = 1.5\nHOUSE = \"of stone\"",
                  &def, message) == MAGGI_OK);
  CHECK_TEXT(message, "");
  CHECK(def.value[MAGGI_TYRE_PEX1] == -0.05);
  CHECK(def.side == MAGGI_RIGHT);
}

static void test_units(void)
{
  maggi_tyre_def def;
  char message[400];

  CHECK(read_more(
            "[UNITS]\nLENGTH = 'mm'\nFORCE = 'kN'\nTIME = 'ms'\nANGLE = 'radians'\nMASS = 'kg'\n"
            "[MODEL]\nVERTICAL_DAMPING = 2\n",
            &def, message) == MAGGI_OK);
  CHECK_NEAR(def.value[MAGGI_TYRE_FNOMIN], 35e6, 1e-15, 0.0);
  CHECK_NEAR(def.value[MAGGI_TYRE_UNLOADED_RADIUS], 0.5e-3, 1e-15, 0.0);
  CHECK_NEAR(def.value[MAGGI_TYRE_VERTICAL_STIFFNESS], 7e11, 1e-15, 0.0);
  CHECK_NEAR(def.value[MAGGI_TYRE_VERTICAL_DAMPING], 2e3, 1e-15, 0.0);
  CHECK(def.value[MAGGI_TYRE_LONGVL] == 16.7); /* not of the file */
  CHECK(def.value[MAGGI_TYRE_PKY1] == -10.0);
}

static void wrong(const char *more, const char *expected)
{
  maggi_tyre_def def;
  char message[400];

  CHECK(read_more(more, &def, message) == MAGGI_E_MODEL);
  CHECK_TEXT(message, expected);
}

static void test_wrong(void)
{
  maggi_tyre_def def;
  char message[400];

  wrong("PEX1 = 1,5\n", "t.tir:15: PEX1: \"1,5\" is not a number");
  wrong("\nPEX1 =\n", "t.tir:16: PEX1: \"\" is not a number");
  wrong("PEX1 = 1e999\n", "t.tir:15: PEX1: \"1e999\" is too large");
  wrong("pcx1 = 2\n", "t.tir:15: \"PCX1\" is here twice, first in line 7");
  wrong("nonsense\n", "t.tir:15: \"nonsense\" is neither [SECTION] nor KEY = value");
  wrong("[UNITS\n", "t.tir:15: \"[UNITS\": a section ends with ]");
  wrong("= 3\n", "t.tir:15: \"\" is no key");
  wrong("FORCE = 'ounce'\n", "t.tir:15: FORCE: unit \"ounce\" is none of newton, n, kilonewton, "
                             "knewton, kn, pound_force, lbf, kilogram_force, kg_force, kgf");
  wrong("ANGLE = 'degrees'\n", "t.tir:15: ANGLE: unit \"degrees\" is none of radian, radians, rad");
  wrong("PROPERTY_FILE_FORMAT = 'FIALA'\n",
        "t.tir:15: PROPERTY_FILE_FORMAT: \"FIALA\" is not PAC2002");
  wrong("TYRESIDE = 'UP'\n", "t.tir:15: TYRESIDE: \"UP\" is none of LEFT, RIGHT");
  CHECK(read("FNOMIN = 3\n", &def, message) == MAGGI_E_MODEL);
  CHECK_TEXT(message, "t.tir: key UNLOADED_RADIUS is missing");
  CHECK(read("", &def, message) == MAGGI_E_MODEL);
}

/* the file of the models has the numbers of the reference */
static void test_keys(void)
{
  char line[200], path[60], message[400], *value, *c;
  maggi_model *m;
  FILE *f = fopen(MAGGI_REFERENCES_DIR "/pac2002/coefficients.csv", "r");
  int i, found = 0;

  CHECK(maggi_model_load(MAGGI_MODELS_DIR "/wheeled-frame.yaml", &m, message, sizeof message) ==
        MAGGI_OK);
  if (!f || !m) exit(1);
  while (fgets(line, sizeof line, f)) {
    value = strchr(line, ',');
    if (!value) continue;
    *value++ = '\0';
    for (c = line; *c; ++c) *c = (char)(*c >= 'A' && *c <= 'Z' ? *c + 32 : *c);
    snprintf(path, sizeof path, "tyres.truck.%.40s", line);
    i = maggi_parameter_find(m, path);
    if (i < 0) continue;
    ++found;
    CHECK(maggi_parameter_default(m, i) == strtod(value, NULL));
  }
  fclose(f);
  CHECK(found == MAGGI_TYRE_NUMBERS - 2); /* all but the widths */
  maggi_model_free(m);
}

int main(void)
{
  test_defaults();
  test_manners();
  test_units();
  test_wrong();
  test_keys();
  return check_done();
}
