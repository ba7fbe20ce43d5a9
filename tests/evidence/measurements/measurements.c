/* Measurement files. Expected rows are read off the texts by hand; refusals are compared as whole
 * messages, because the message is the contract: file, line, what is wrong, what is accepted. */
#include <signal.h>
#include <sys/resource.h>

#include "base/core/constants.h"
#include "base/core/file.h"
#include "evidence/measurements/measurements.h"
#include "evidence/measurements/write.h"
#include "orbit/time.h"
#include "tests/evidence/compare_test.h"

#define HEAD "time_utc,quantity,of,value,sigma\n"
#define T0   "2016-09-21T20:36:40.000Z"
#define T1   "2016-09-21T20:36:41.000Z"

#define ACCEPTED_COLUMNS                                                                           \
  "time_utc, time_unix_s, jd_utc, mjd_utc, quantity, of, value, sigma, exposure_s, flag, track, "  \
  "satellite_height_km, azimuth_deg, elevation_deg, station"

static double utc(const char *text)
{
  double t;
  assert_ok(um_orbit_time_parse(context, text, &t));
  return t;
}

static void test_plain(void **state)
{
  (void)state;
  struct um_compare_measurements *m;
  put("m.csv", "# made by hand\n" HEAD T0 ",band_irradiance,lwir,1.23e-10,2.0e-12\n" T0
               ",temperature,solar_array.front,281.4,0.5\n" T1 ",band_irradiance,lwir,-1e-13,\n");
  assert_ok(um_compare_measurements_read(context, "m.csv", &m));
  assert_string_equal(m->path, "m.csv");
  assert_int_equal(m->count, 3);
  assert_int_equal(m->nchannel, 2);
  assert_int_equal(m->ntrack, 1);
  assert_int_equal(m->nstation, 0);
  assert_string_equal(m->track[0], "");
  assert_false(m->independent);
  assert_int_equal(m->channel[0].quantity, UM_QUANTITY_BAND_IRRADIANCE);
  assert_string_equal(m->channel[0].of, "lwir");
  assert_int_equal(m->channel[0].count, 2);
  assert_string_equal(m->channel[1].of, "solar_array.front");
  assert_int_equal(m->channel[1].count, 1);
  assert_true(m->row[0].t_tai == utc(T0) && m->row[2].t_tai == utc(T1));
  assert_true(m->row[0].value == 1.23e-10 && m->row[0].sigma == 2.0e-12);
  assert_true(m->row[2].value == -1e-13 && isnan(m->row[2].sigma));
  assert_true(isnan(m->row[0].exposure) && isnan(m->row[0].elevation));
  assert_int_equal(m->row[0].flag, 0);
  assert_int_equal(m->row[1].channel, 1);
  assert_int_equal(m->row[2].line, 5);
  assert_true(m->row[0].station == SIZE_MAX);
  um_compare_measurements_destroy(context, &m);
  assert_null(m);
  um_compare_measurements_destroy(context, &m);
  um_compare_measurements_destroy(context, NULL);
}

/* All optional columns, in another order; two tracks whose times overlap, which is allowed. */
static const char full[] =
    "station,track,elevation_deg,azimuth_deg,satellite_height_km,flag,exposure_s,sigma,value,of,"
    "quantity,time_utc\n"
    "Mt Lemmon,a,30,180,550,0,0.5,0.1,5.25,V,magnitude_vega," T1 "\n"
    "\"Graz, Lustbuehel\",b,-5.5,270,550.125,3,,0.2,6,\"V, wide\",magnitude_ab," T0 "\n"
    ",a,45,360,551,,0,,5.5,V,magnitude_vega,2016-09-21T20:36:41.000250Z\n";

static void test_optional(void **state)
{
  (void)state;
  struct um_compare_measurements *m;
  put("m.csv", full);
  assert_ok(um_compare_measurements_read(context, "m.csv", &m));
  assert_true(m->independent);
  assert_int_equal(m->count, 3);
  assert_int_equal(m->ntrack, 2);
  assert_int_equal(m->nstation, 2);
  assert_string_equal(m->track[1], "b");
  assert_string_equal(m->station[1], "Graz, Lustbuehel");
  assert_string_equal(m->channel[1].of, "V, wide");
  assert_int_equal(m->channel[1].quantity, UM_QUANTITY_MAGNITUDE_AB);
  assert_int_equal(m->row[1].track, 1);
  assert_int_equal(m->row[1].flag, 3);
  assert_int_equal(m->row[2].flag, 0);
  assert_true(m->row[2].station == SIZE_MAX);
  assert_true(m->row[0].exposure == 0.5 && isnan(m->row[1].exposure) && m->row[2].exposure == 0.0);
  assert_true(m->row[1].satellite_height == 550125.0);
  /* degrees to radians: one rounding */
  assert_close(m->row[0].azimuth, UM_PI, 1e-15);
  assert_close(m->row[1].elevation, -0.095993108859688, 1e-15);
  um_compare_measurements_destroy(context, &m);
}

static void assert_same(double a, double b)
{
  if (!(a == b || (isnan(a) && isnan(b)))) fail_msg("%.17g is not %.17g", a, b);
}

/* What is written reads back as the same set: numbers exactly, angles within two roundings of the
 * unit. Writing what was read back gives the same bytes. */
static void round_trip(const char *text, const char *expected)
{
  struct um_compare_measurements *a, *b;
  char *bytes = NULL;
  put("m.csv", text);
  assert_ok(um_compare_measurements_read(context, "m.csv", &a));
  assert_ok(um_compare_measurements_write(context, a, "w.csv"));
  FILE *file = fopen("w.csv", "rb");
  assert_non_null(file);
  bytes = test_calloc(1, strlen(expected) + 4096);
  assert_true(fread(bytes, 1, strlen(expected) + 4095, file) > 0);
  fclose(file);
  assert_string_equal(bytes, expected);
  test_free(bytes);
  assert_ok(um_compare_measurements_read(context, "w.csv", &b));
  assert_int_equal(a->count, b->count);
  for (size_t i = 0; i < a->count; i++) {
    const struct um_compare_measurement *x = &a->row[i], *y = &b->row[i];
    assert_close(x->t_tai, y->t_tai, 2e-7); /* a double of t_tai resolves 1.2e-7 s */
    assert_same(x->value, y->value);
    assert_same(x->sigma, y->sigma);
    assert_same(x->exposure, y->exposure);
    assert_int_equal(x->flag, y->flag);
    assert_int_equal(x->channel, y->channel);
    assert_int_equal(x->track, y->track);
    assert_true(x->station == y->station);
    if (!a->independent) continue;
    assert_close(x->satellite_height, y->satellite_height, 1e-7);
    assert_close(x->azimuth, y->azimuth, 2e-12);
    assert_close(x->elevation, y->elevation, 2e-12);
  }
  um_compare_measurements_destroy(context, &a);
  um_compare_measurements_destroy(context, &b);
}

static void test_round_trip(void **state)
{
  (void)state;
  round_trip(HEAD T0 ",band_irradiance,lwir,1.23e-10,2e-12\n" T1 ",count_rate,ufo,-0.1,\n",
             HEAD T0 ",band_irradiance,lwir,1.23e-10,2e-12\n" T1 ",count_rate,ufo,-0.1,\n");
  round_trip(full, "time_utc,quantity,of,value,sigma,exposure_s,flag,track,satellite_height_km,"
                   "azimuth_deg,elevation_deg,station\n" T1
                   ",magnitude_vega,V,5.25,0.1,0.5,0,a,550,180,30,Mt Lemmon\n" T0
                   ",magnitude_ab,\"V, wide\",6,0.2,,3,b,550.125,270,-5.5,\"Graz, Lustbuehel\"\n"
                   "2016-09-21T20:36:41.000250Z,magnitude_vega,V,5.5,,0,0,a,551,360,45,\n");
  /* digits that nine places do not hold */
  round_trip(HEAD T0 ",radiant_intensity,vis,0.30000000000000004,1.2345678901234568e-300\n",
             HEAD T0 ",radiant_intensity,vis,0.30000000000000004,1.2345678901234568e-300\n");
  /* microseconds that round to the next millisecond; one name for two quantities */
  const char *close_rows = HEAD "2016-12-31T23:59:60.999750Z,band_irradiance,bus,1,\n"
                                "2017-01-01T00:00:00.000Z,temperature,bus,280,\n";
  round_trip(close_rows, close_rows);
}

/* Neither a failed write nor a refused value leaves a file or touches the old one. */
static void test_write_whole(void **state)
{
  (void)state;
  struct um_compare_measurements *m;
  put("m.csv", HEAD T0 ",count_rate,ufo,1,1\n");
  assert_ok(um_compare_measurements_read(context, "m.csv", &m));
  assert_refused(um_compare_measurements_write(context, m, "no-such-folder/w.csv"), UM_ERR_IO,
                 "no-such-folder/w.csv: No such file or directory");
  put("w.csv", "old\n");
  m->row[0].value = INFINITY;
  assert_refused(um_compare_measurements_write(context, m, "w.csv"), UM_ERR_NUMERIC,
                 "w.csv: row 1 (count_rate 'ufo'): time, value, sigma, exposure or geometry is not "
                 "finite");
  char text[8] = "";
  FILE *file = fopen("w.csv", "rb");
  assert_non_null(file);
  assert_int_equal(fread(text, 1, 7, file), 4);
  fclose(file);
  assert_string_equal(text, "old\n");
  if (access("/dev/full", W_OK) == 0) {
    m->row[0].value = 1.0;
    assert_refused(um_compare_measurements_write(context, m, "/dev/full"), UM_ERR_IO,
                   "/dev/full: cannot be written: No space left on device");
  }
  /* a file that may not grow beyond 8 bytes: nothing half-written stays, which removing the folder
   * at the end proves */
  struct rlimit limit, small;
  assert_int_equal(getrlimit(RLIMIT_FSIZE, &limit), 0);
  small = (struct rlimit){8, limit.rlim_max};
  void (*before)(int) = signal(SIGXFSZ, SIG_IGN);
  m->row[0].value = 1.0;
  assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
  um_core_message_clear(context);
  enum um_status status = um_compare_measurements_write(context, m, "w.csv");
  assert_int_equal(setrlimit(RLIMIT_FSIZE, &limit), 0);
  signal(SIGXFSZ, before);
  assert_int_equal(status, UM_ERR_IO);
  assert_string_equal(um_core_message(context), "w.csv: cannot be written: File too large");
  um_compare_measurements_destroy(context, &m);
}

/* One instant in the four forms, and what is written of each. 20:33 is 0.85625 of a day. */
static void test_forms_of_time(void **state)
{
  (void)state;
  static const struct {
    const char *column, *text;
  } forms[] = {{"time_utc", "2016-09-21T20:33:00.000Z"},
               {"time_utc", "2016-09-21 20:33:00"},
               {"time_utc", "2016-09-21 20:33:00.000Z"},
               {"time_unix_s", "1474489980"},
               {"time_unix_s", "1474489980.000"},
               {"jd_utc", "2457653.35625"},
               {"mjd_utc", "57652.856250000"}};
  for (size_t i = 0; i < sizeof forms / sizeof forms[0]; i++) {
    char text[160];
    struct um_compare_measurements *m;
    snprintf(text, sizeof text, "quantity,%s,of,value,sigma\ncount_rate,%s,ufo,1,\n",
             forms[i].column, forms[i].text);
    round_trip(text, HEAD "2016-09-21T20:33:00.000Z,count_rate,ufo,1,\n");
    assert_ok(um_compare_measurements_read(context, "m.csv", &m));
    assert_string_equal(m->file[0].time_column, forms[i].column);
    assert_close(m->row[0].t_tai, utc("2016-09-21T20:33:00Z"), 2e-7);
    um_compare_measurements_destroy(context, &m);
  }
  /* 0.123456 s: a double of the Julian date would be up to 20 us off */
  round_trip("jd_utc,quantity,of,value,sigma\n2457653.356251428888888,count_rate,ufo,1,\n",
             HEAD "2016-09-21T20:33:00.123456Z,count_rate,ufo,1,\n");
}

/* Celsius and kelvin of one place are one channel; cold that is meant stays cold when written. */
static void test_temperatures(void **state)
{
  (void)state;
  round_trip(HEAD T0 ",temperature_C,bus,-12.5,0.5\n" T1 ",temperature,bus,281.25,0.5\n",
             HEAD T0 ",temperature,bus,260.65,0.5\n" T1 ",temperature,bus,281.25,0.5\n");
  round_trip(HEAD T0 ",temperature_K,detector,40,0.01\n" T1 ",temperature_C,detector,-230,0.01\n",
             HEAD T0 ",temperature_K,detector,40,0.01\n" T1
                     ",temperature_K,detector,43.14999999999998,0.01\n");
  /* 100 K once is enough: kelvin of an array that falls far in a long eclipse */
  round_trip(HEAD T0 ",temperature,array,310,\n" T1 ",temperature,array,95,\n",
             HEAD T0 ",temperature,array,310,\n" T1 ",temperature_K,array,95,\n");
}

/* The manual's example is read, and its tables name every column and quantity. */
static void test_manual(void **state)
{
  (void)state;
  char *page = NULL;
  size_t length;
  assert_ok(um_core_file_read(context, UMBRA_SOURCE_DIR "/docs/files.md", 1 << 20, &page, &length));
  for (const char *c = ACCEPTED_COLUMNS; *c != '\0'; c += strspn(c, ", ")) {
    char row[64];
    size_t n = strcspn(c, ",");
    snprintf(row, sizeof row, "\n| `%.*s` | ", (int)n, c);
    if (strstr(page, row) == NULL) fail_msg("docs/files.md has no row '%s'", row);
    c += n;
  }
  for (int q = 0; q < UM_QUANTITY_COUNT; q++) {
    char row[64];
    snprintf(row, sizeof row, "\n| `%s`", um_compare_quantity_name((enum um_compare_quantity)q));
    if (strstr(page, row) == NULL) fail_msg("docs/files.md has no quantity '%s'", row);
  }
  char *block = strstr(page, "```csv\n"), *end = block == NULL ? NULL : strstr(block, "\n```\n");
  assert_non_null(end);
  end[1] = '\0';
  put("m.csv", block + strlen("```csv\n"));
  struct um_compare_measurements *m;
  assert_ok(um_compare_measurements_read(context, "m.csv", &m));
  assert_int_equal(m->count, 5);
  assert_int_equal(m->nchannel, 3);
  assert_close(m->row[3].value, 281.4, 1e-12);
  assert_int_equal(m->row[2].flag, 1);
  um_compare_measurements_destroy(context, &m);
  um_core_free(context, page);
}

struct refusal {
  const char *text, *message;
};

#define PLACE_HEAD                                                                                 \
  "time_utc,quantity,of,value,sigma,satellite_height_km,azimuth_deg,elevation_deg\n"

static const struct refusal refusals[] = {
    {"", "m.csv: empty; accepted: CSV with a header row"},
    {HEAD, "m.csv: no measurements; accepted: at least one row below the header"},
    /* columns */
    {"time_utc,quantity,of,value\n", "m.csv:1: column 'sigma' is missing; the file has: time_utc, "
                                     "quantity, of, value"},
    {"# c\nquantity,of,value,sigma\n",
     "m.csv:2: column 'time_utc' is missing; the file has: quantity, of, value, sigma"},
    {"time_utc,quantity,of,value,sigma,valu\n",
     "m.csv: header: unknown column 'valu'; did you mean 'value'?; accepted: " ACCEPTED_COLUMNS},
    {"time_utc,quantity,of,value_W,sigma\n",
     "m.csv: header: unknown column 'value_W'; did you mean 'value'?; accepted: " ACCEPTED_COLUMNS},
    {"time_utc,quantity,of,value,sigma,satellite_height_m,azimuth_deg,elevation_deg\n",
     "m.csv: header: unknown column 'satellite_height_m'; did you mean 'satellite_height_km'?; "
     "accepted: " ACCEPTED_COLUMNS},
    {"time_utc,quantity,of,value,sigma,weather\n",
     "m.csv: header: unknown column 'weather'; accepted: " ACCEPTED_COLUMNS},
    {"time_utc,quantity,of,value,sigma,sigma\n", "m.csv:1: column 'sigma' appears twice"},
    {"time_utc,quantity,of,value,sigma,azimuth_deg,elevation_deg\n",
     "m.csv: header: column 'satellite_height_km' is missing; accepted: satellite_height_km, "
     "azimuth_deg and elevation_deg together, or none of them"},
    {HEAD T0 ",count_rate,ufo,1\n",
     "m.csv:2: 4 fields; accepted: 5, as many as the header has columns"},
    /* fields */
    {HEAD "2016-09-21 20:36,count_rate,ufo,1,1\n",
     "m.csv:2: column 'time_utc': '2016-09-21 20:36' is not a UTC time like "
     "2016-09-21T20:33:00.000Z"},
    {HEAD "2016-09-31T20:36:00Z,count_rate,ufo,1,1\n",
     "m.csv:2: column 'time_utc': '2016-09-31T20:36:00Z': that month does not have this day"},
    {HEAD T0 ",irradiance,vis,1,1\n",
     "m.csv:2: column 'quantity': unknown quantity 'irradiance'; did you mean "
     "'band_irradiance'?; accepted: band_irradiance, radiant_intensity, magnitude_ab, "
     "magnitude_vega, count_rate, temperature, characteristic_temperature, "
     "infrared_cross_section, temperature_C, temperature_K"},
    {HEAD T0 ",temperature_c,bus,1,1\n",
     "m.csv:2: column 'quantity': unknown quantity 'temperature_c'; did you mean 'temperature_C'?; "
     "accepted: band_irradiance, radiant_intensity, magnitude_ab, magnitude_vega, count_rate, "
     "temperature, characteristic_temperature, infrared_cross_section, temperature_C, "
     "temperature_K"},
    {HEAD T0 ",count_rate,,1,1\n",
     "m.csv:2: column 'of': empty; accepted: the name of a band, part, side, node, filter or "
     "sensor"},
    {HEAD T0 ",count_rate,ufo,,1\n", "m.csv:2: column 'value': '' is not a finite number"},
    {HEAD T0 ",count_rate,ufo,nan,1\n", "m.csv:2: column 'value': 'nan' is not a finite number"},
    {HEAD T0 ",count_rate,ufo,1e999,1\n",
     "m.csv:2: column 'value': '1e999' is not a finite number"},
    {HEAD T0 ",count_rate,ufo,1.5 m,1\n",
     "m.csv:2: column 'value': '1.5 m' is not a finite number"},
    {HEAD T0 ",count_rate,ufo,1,inf\n", "m.csv:2: column 'sigma': 'inf' is not a finite number"},
    {HEAD T0 ",count_rate,ufo,1,0\n",
     "m.csv:2: column 'sigma': 0 1/s; accepted: above 0, or empty where the scenario gives a noise "
     "model"},
    {HEAD T0 ",band_irradiance,vis,1e-12,-2e-13\n",
     "m.csv:2: column 'sigma': -2e-13 W/m^2; accepted: above 0, or empty where the scenario gives "
     "a noise model"},
    {HEAD T0 ",temperature,bus,-12.5,1\n",
     "m.csv:2: column 'value': temperature -12.5 K; accepted: above 0 K (Celsius is the quantity "
     "temperature_C)"},
    {HEAD T0 ",temperature,bus,0,1\n",
     "m.csv:2: column 'value': temperature 0 K; accepted: above 0 K (Celsius is the quantity "
     "temperature_C)"},
    {HEAD T0 ",temperature_C,bus,-273.15,1\n",
     "m.csv:2: column 'value': temperature -273.15 C; accepted: above -273.15 C"},
    {HEAD T0 ",temperature_K,bus,-1,1\n",
     "m.csv:2: column 'value': temperature -1 K; accepted: above 0 K (Celsius is the quantity "
     "temperature_C)"},
    /* one place in kelvin, the other cannot be */
    {HEAD T0 ",temperature,bus,290,1\n" T0 ",temperature,array,21.5,1\n" T1
             ",temperature,array,84,1\n",
     "m.csv:3: column 'value': temperature of 'array' is never above 84 K, is it Celsius? "
     "accepted: "
     "100 K somewhere, or a quantity that names its unit, temperature_C or temperature_K"},
    /* times */
    {"time_utc,jd_utc,quantity,of,value,sigma\n" T0 ",2457653,count_rate,ufo,1,1\n",
     "m.csv: header: columns 'time_utc' and 'jd_utc'; accepted: one column of times"},
    {"jd,quantity,of,value,sigma\n2457653,count_rate,ufo,1,1\n",
     "m.csv: header: unknown column 'jd'; did you mean 'jd_utc'?; accepted: " ACCEPTED_COLUMNS},
    {HEAD "1474489980,count_rate,ufo,1,1\n",
     "m.csv:2: column 'time_utc': '1474489980' is not a UTC time like 2016-09-21T20:33:00.000Z; "
     "seconds since 1970 stand in a column time_unix_s"},
    {HEAD "2457653.35625,count_rate,ufo,1,1\n",
     "m.csv:2: column 'time_utc': '2457653.35625' is not a UTC time like 2016-09-21T20:33:00.000Z; "
     "Julian dates stand in a column jd_utc"},
    {"jd_utc,quantity,of,value,sigma\n57652.85625,count_rate,ufo,1,1\n",
     "m.csv:2: column 'jd_utc': '57652.85625' is not a Julian date like 2457653.35625000, of 1960 "
     "to "
     "2100; modified Julian dates stand in a column mjd_utc"},
    {"time_unix_s,quantity,of,value,sigma\n1474489980000,count_rate,ufo,1,1\n",
     "m.csv:2: column 'time_unix_s': '1474489980000' is not seconds since 1970-01-01T00:00:00Z "
     "like "
     "1474489980.000, of 1960 to 2100; milliseconds are not taken, seconds stand in a column "
     "time_unix_s"},
    {"time_unix_s,quantity,of,value,sigma\n1.47448998e9,count_rate,ufo,1,1\n",
     "m.csv:2: column 'time_unix_s': '1.47448998e9' is not seconds since 1970-01-01T00:00:00Z like "
     "1474489980.000, digits without exponent"},
    {"mjd_utc,quantity,of,value,sigma\n57652.9,count_rate,ufo,1,1\n"
     "57652.85625,temperature,bus,280,1\n",
     "m.csv:3: column 'mjd_utc': 2016-09-21T20:33:00.000Z is before 2016-09-21T21:36:00.000Z of "
     "line 2 in track ''; accepted: rows in time order within a track"},
    {HEAD T0 ",magnitude_ab,V,99.9,1\n",
     "m.csv:2: column 'value': magnitude 99.9 mag; accepted: -40 to 40 mag"},
    {"time_utc,quantity,of,value,sigma,exposure_s\n" T0 ",count_rate,ufo,1,1,-1\n",
     "m.csv:2: column 'exposure_s': -1 s; accepted: 0 s or more, or empty"},
    {"time_utc,quantity,of,value,sigma,flag\n" T0 ",count_rate,ufo,1,1,0.5\n",
     "m.csv:2: column 'flag': '0.5' is not a whole number; accepted: 0 (use), any other (leave "
     "out)"},
    {"time_utc,quantity,of,value,sigma,flag\n" T0 ",count_rate,ufo,1,1,bad\n",
     "m.csv:2: column 'flag': 'bad' is not a finite number"},
    /* places */
    {PLACE_HEAD T0 ",magnitude_ab,V,5,1,550,,30\n",
     "m.csv:2: column 'azimuth_deg': empty; accepted: satellite height, azimuth and elevation in "
     "every row"},
    {PLACE_HEAD T0 ",magnitude_ab,V,5,1,0,180,30\n",
     "m.csv:2: column 'satellite_height_km': 0; accepted: 0.001 to 1e6 km"},
    {PLACE_HEAD T0 ",magnitude_ab,V,5,1,550,400,30\n",
     "m.csv:2: column 'azimuth_deg': 400; accepted: -360 to 360 deg"},
    {PLACE_HEAD T0 ",magnitude_ab,V,5,1,550,180,91\n",
     "m.csv:2: column 'elevation_deg': 91; accepted: -90 to 90 deg"},
    /* between rows */
    {HEAD T1 ",count_rate,ufo,1,1\n" T0 ",temperature,bus,1,1\n",
     "m.csv:3: column 'time_utc': 2016-09-21T20:36:40.000Z is before 2016-09-21T20:36:41.000Z of "
     "line 2 in track ''; accepted: rows in time order within a track"},
    {HEAD T0 ",count_rate,ufo,1,1\n" T0 ",temperature,bus,1,1\n" T0 ",count_rate,ufo,2,1\n",
     "m.csv:4: column 'time_utc': second row of count_rate 'ufo' at 2016-09-21T20:36:40.000Z in "
     "track '', the first is line 2; accepted: one"},
    {"time_utc,quantity,of,value,sigma,track\n" T0 ",count_rate,ufo,1,1,a\n" T0
     ",count_rate,ufo,1,1,b\n" T0 ",count_rate,ufo,1,1,a\n",
     "m.csv:4: column 'time_utc': second row of count_rate 'ufo' at 2016-09-21T20:36:40.000Z in "
     "track 'a', the first is line 2; accepted: one"}};

static void test_refusals(void **state)
{
  (void)state;
  for (size_t i = 0; i < sizeof refusals / sizeof refusals[0]; i++) {
    struct um_compare_measurements *m = NULL;
    put("m.csv", refusals[i].text);
    assert_refused(um_compare_measurements_read(context, "m.csv", &m), UM_ERR_INPUT,
                   refusals[i].message);
    assert_null(m);
  }
  struct um_compare_measurements *m = NULL;
  assert_refused(um_compare_measurements_read(context, "none.csv", &m), UM_ERR_IO,
                 "none.csv: No such file or directory");
  assert_refused(um_compare_measurements_read(context, ".", &m), UM_ERR_IO,
                 ".: is not a plain file but a folder");
}

/* A file with one byte changed, at every byte in turn: read or refused in one line, never a crash.
 */
static void test_damage(void **state)
{
  (void)state;
  char text[sizeof full];
  for (size_t i = 0; i + 1 < sizeof full; i++) {
    struct um_compare_measurements *m = NULL;
    memcpy(text, full, sizeof full);
    text[i] = (char)(1 + um_core_hash(7, i) % 127);
    put("m.csv", text);
    um_core_message_clear(context);
    enum um_status status = um_compare_measurements_read(context, "m.csv", &m);
    assert_true(status == UM_OK || status == UM_ERR_INPUT);
    assert_true((status == UM_OK) == (m != NULL));
    if (status != UM_OK) assert_true(strncmp(um_core_message(context), "m.csv:", 6) == 0);
    um_compare_measurements_destroy(context, &m);
  }
}

/* 20 000 tracks of one row: the table of names grows and stays fast. */
static void test_many_tracks(void **state)
{
  (void)state;
  struct um_compare_measurements *m;
  FILE *file = fopen("m.csv", "wb");
  assert_non_null(file);
  fputs("time_utc,quantity,of,value,sigma,track\n", file);
  for (int i = 0; i < 20000; i++) fprintf(file, T0 ",count_rate,ufo,%d,1,t%d\n", i, i);
  fclose(file);
  assert_ok(um_compare_measurements_read(context, "m.csv", &m));
  assert_int_equal(m->ntrack, 20000);
  assert_string_equal(m->track[m->row[12345].track], "t12345");
  um_compare_measurements_destroy(context, &m);
}

/* The blind sets: rows of each channel as a count of the lines says. */
static void test_blind(void **state)
{
  (void)state;
  static const struct {
    const char *name;
    size_t count, vis, lwir, temperatures;
  } sets[] = {{"a", 372, 165, 165, 42}, {"b", 663, 105, 105, 453}, {"c", 264, 117, 117, 30},
              {"d", 295, 131, 131, 33}, {"e", 416, 208, 208, 0},   {"f", 358, 165, 165, 28},
              {"g", 431, 57, 57, 317},  {"h", 376, 29, 29, 318}};
  for (size_t k = 0; k < sizeof sets / sizeof sets[0]; k++) {
    char path[1024];
    struct um_compare_measurements *m;
    size_t vis = 0, lwir = 0, temperatures = 0;
    snprintf(path, sizeof path, "%s/scenarios/blind/%s/measured.csv", UMBRA_SOURCE_DIR,
             sets[k].name);
    assert_ok(um_compare_measurements_read(context, path, &m));
    assert_int_equal(m->count, sets[k].count);
    for (size_t i = 0; i < m->nchannel; i++) {
      size_t n = m->channel[i].count;
      if (m->channel[i].quantity == UM_QUANTITY_TEMPERATURE)
        temperatures += n;
      else if (strcmp(m->channel[i].of, "vis") == 0)
        vis += n;
      else
        lwir += n;
    }
    assert_int_equal(vis, sets[k].vis);
    assert_int_equal(lwir, sets[k].lwir);
    assert_int_equal(temperatures, sets[k].temperatures);
    for (size_t i = 0; i < m->count; i++) assert_true(m->row[i].sigma > 0.0);
    um_compare_measurements_destroy(context, &m);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_plain),         cmocka_unit_test(test_optional),
      cmocka_unit_test(test_round_trip),    cmocka_unit_test(test_write_whole),
      cmocka_unit_test(test_refusals),      cmocka_unit_test(test_damage),
      cmocka_unit_test(test_many_tracks),   cmocka_unit_test(test_blind),
      cmocka_unit_test(test_forms_of_time), cmocka_unit_test(test_temperatures),
      cmocka_unit_test(test_manual)};
  return cmocka_run_group_tests(tests, compare_set_up, compare_tear_down);
}
