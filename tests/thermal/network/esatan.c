/* Networks of ESATAN: what a file says, node by node; steady states in closed form; every fault's
 * exact message. */
#include <unistd.h>

#include "tests/support/temporary.h"
#include "tests/thermal/network_help.h"
#include "thermal/network/network_group.h"
#include "thermal/network/network_write.h"

#define ZERO   273.15
#define STEFAN 5.6686e-8 /* ESATAN's own, where a file does not say */

static enum um_status read_text(const char *text, struct um_thermal_network **out)
{
  FILE *file = fopen("model.d", "w");
  assert_non_null(file);
  fputs(text, file);
  assert_int_equal(fclose(file), 0);
  enum um_status status = um_thermal_network_read(help_context, "model.d", NULL, out);
  assert_int_equal(remove("model.d"), 0);
  return status;
}

static struct um_thermal_network *read_well(const char *text)
{
  struct um_thermal_network *network = NULL;
  OK(read_text(text, &network));
  return network;
}

/* A unit on a radiator: T_r = (Q / (STEFAN A eps) + T_s^4)^(1/4), T_u = T_r + Q / GL. Constants
 * stand before and behind their use, one of another; comments hold ; $ and '. */
static const char radiator[] =
    "# a unit; $NODES of 'nothing'\n"
    "$MODEL RADIATOR, GLOBALFILE = none.gbl\n"
    "  $LOCALS\n    $REAL\n"
    "    k_Al = 180.0; width = 0.2; side = 2.0 * width / (1 + 3.0D0) - (-0.1) * 1.E0; # all of "
    "it;\n"
    "  $NODES\n"
    "D10 = 'Unit; top, 1', T = 20.0, C = 500.0 * k_Al ** 2 ** 0, QI = 10.0,\n"
    "   QS = 1.0, QA = 0.5, QE = 0.25, QR = 0.25, FX = 1, FY = 2;\n"
    "D70='Radiator', T=temp, C = width * RadLen * 1e3, EPS = 0.9, A = width * RadLen;\n"
    "A80 = 'side', T = 20.0;\nD90, T = 20.0;\nX95 = 'gone', T = 1.0;\n"
    "B999= 'Deep Space', T = -270.0;\n"
    "  $CONDUCTORS\n"
    "GR(70,999) = A70 * EPS:70; GL(10, 70) = side / 0.2 * 1.5;\n"
    "gl( 80 ,70)= 0.5; GL(80,10) = 0; GL(90,70) = 1; GL(95,10) = 7;\n"
    "  $CONSTANTS\n    $REAL\n RadLen = 0.2;\n temp = 20.0;\n"
    "    $CHARACTER\n NAME = 'a;b';\n    $CONTROL\n  NLOOP = 100;\n"
    "  $ARRAYS\n    $REAL\n   TIMES(2) = 0.0, 1.0;\n"
    "  $SUBROUTINES\nC\n"
    "  $EXECUTION\nC a comment\n      CALL SOLVFM\n  $OUTPUTS\n      CALL PRNDTB(' ')\n"
    "$ENDMODEL RADIATOR\nrest ;;; $NODES\n";

static void says_what_it_says(void **state)
{
  (void)state;
  struct um_thermal_network *network = read_well(radiator);
  static const struct {
    const char *name;
    enum um_thermal_node_kind kind;
    double t, c, q;
  } nodes[] = {{"10", UM_NODE_DIFFUSIVE, 20.0, 500.0 * 180.0, 12.0}, /* ; and , name no place */
               {"Radiator", UM_NODE_DIFFUSIVE, 20.0, 40.0, 0.0},
               {"side", UM_NODE_ARITHMETIC, 20.0, 0.0, 0.0},
               {"90", UM_NODE_ARITHMETIC, 20.0, 0.0, 0.0},
               {"Deep Space", UM_NODE_BOUNDARY, -270.0, 0.0, 0.0}};
  assert_int_equal(um_thermal_network_nodes(network), 5);
  for (uint32_t i = 0; i < 5; i++) {
    assert_string_equal(um_thermal_network_name(network, i), nodes[i].name);
    assert_int_equal(um_thermal_network_kind(network, i), nodes[i].kind);
    NEAR("T", um_thermal_network_temperature(network, i), nodes[i].t + ZERO, 1e-12);
    NEAR("C", um_thermal_network_capacity(network, i), nodes[i].c, 1e-12 * nodes[i].c);
    NEAR("Q", um_thermal_network_power(network, i), nodes[i].q, 1e-12);
  }
  assert_int_equal(network->nconductor, 4);
  NEAR("GL", network->conductor[0].value, 1.5, 1e-12); /* side is 0.2 m */
  NEAR("GR", network->radiator[0].value, 0.036 * STEFAN / UM_STEFAN_BOLTZMANN, 1e-15);

  double t[5];
  struct um_thermal_solve_options options = help_options(1e-9, 1e-9, 0.0);
  OK(um_thermal_solve_steady(help_context, network, NULL, 0, &options, NULL, t));
  double cold = pow(12.0 / (STEFAN * 0.036) + pow(-270.0 + ZERO, 4), 0.25);
  NEAR("radiator", t[1], cold, 1e-7);
  NEAR("unit", t[0], cold + 12.0 / 1.5, 1e-7);
  NEAR("side", t[2], cold, 1e-7);
  um_thermal_network_destroy(&network);
}

/* As programs write them: assignments before the solution, labels that are not unique, STEFAN of
 * the file; boundary made of a node. What is done over time is said to be missing. */
static void does_what_is_done_once(void **state)
{
  (void)state;
  um_core_log_clear(help_context);
  struct um_thermal_network *network = read_well(
      "$MODEL DISC\n  $LOCALS\n    $REAL\n      k = 0.2;  heat = 1.0;\n#\n  $NODES\n"
      "    D1000 = 'DISC', T = 0.0,\n     C = 3.1E-007 * 2900.0,\n     A = 0.000063;\n"
      "    D1001 = 'DISC', T = 0.0, C = 1.0;\n    D2000 = 'SPACE', T = 0.0;\n"
      "  $CONDUCTORS\n    GL(1000,1001) = k * 0.5; # from primitive DISC\n"
      "    GR(1001, 2000) = 1.99807E-002;\n  $INITIAL\nC\n\n"
      "      CALL STATST('N2000', 'B')\n      T2000 = -10.0\n      heat = 2.0\n"
      "      QI1000 = heat + 1.0\n  $EXECUTION\nC\n"
      "      STEFAN=5.670374419E-8\n      CALL SOLVFM\n"
      "  $VARIABLES1\n      QI1001 = INTCYC(TIMEM, A, B, 1)\n      T1001 = 3\n$ENDMODEL\n");
  assert_string_equal(um_thermal_network_name(network, 0), "1000");
  assert_string_equal(um_thermal_network_name(network, 2), "SPACE");
  assert_int_equal(um_thermal_network_kind(network, 2), UM_NODE_BOUNDARY);
  NEAR("space", um_thermal_network_temperature(network, 2), 263.15, 1e-12);
  NEAR("heat", um_thermal_network_power(network, 0), 3.0, 1e-12);
  NEAR("GR", network->radiator[0].value, 1.99807e-2, 1e-15);
  assert_non_null(strstr(um_core_log_text(help_context),
                         "model.d:27: 'QI1001 = INTCYC(TIMEM, A, B, 1)' is not followed, nor are 1 "
                         "other statements; what they do to nodes and conductors is missing"));
  um_thermal_network_destroy(&network);
}

/* Written and read again: every number is the same, or in kelvins to their digits. */
static void round_trip(void **state)
{
  (void)state;
  const struct um_thermal_network_note note = {"x", 2.7};
  struct um_thermal_network *a = read_well(radiator), *b = NULL;
  OK(um_thermal_network_radiator_add(a, 0, UM_THERMAL_SPACE, 0.1 / 3.0));
  OK(um_thermal_network_conductor_add(a, 0, 3, 1.0 / 7.0));
  FILE *file = fopen("model.d", "w");
  assert_non_null(file);
  um_thermal_network_write_esatan(a, &note, file);
  assert_int_equal(fclose(file), 0);
  OK(um_thermal_network_read(help_context, "model.d", NULL, &b));
  assert_int_equal(b->nnode, a->nnode + 1);
  for (uint32_t i = 0; i < a->nnode; i++) {
    assert_int_equal(b->node[i].kind, a->node[i].kind);
    NEAR("T", b->node[i].temperature, a->node[i].temperature, 1e-12);
    NEAR("C", b->node[i].capacity, a->node[i].capacity, 0.0);
    NEAR("Q", b->node[i].power, a->node[i].power, 0.0);
  }
  NEAR("space", b->node[a->nnode].temperature, 2.7, 1e-12);
  assert_int_equal(b->node[a->nnode].kind, UM_NODE_BOUNDARY);
  assert_int_equal(b->nconductor, a->nconductor);
  for (size_t k = 0; k < a->nconductor; k++)
    NEAR("GL", b->conductor[k].value, a->conductor[k].value, 0.0);
  for (size_t k = 0; k < a->nradiator; k++)
    NEAR("GR", b->radiator[k].value, a->radiator[k].value, 0.0);
  assert_int_equal(b->radiator[1].b, a->nnode);
  um_thermal_network_destroy(&a);
  um_thermal_network_destroy(&b);
  remove("model.d");
}

#define BEFORE "$MODEL M\n$NODES\nD1, T = 0, C = 1;\nB2, T = 0;\n"

static void faults(void **state)
{
  (void)state;
  static const struct {
    const char *text, *says;
  } rows[] = {
      {"$MODEL M\n$NODES\nD1, T = 0\n$CONDUCTORS\n",
       "model.d:3: 'D1, T = 0': the ';' behind it is missing"},
      {"$MODEL M\n$NODES\nD1 = 'x\n', T = 0;\n", "model.d:3: 'D1 = 'x': the quote behind it is "},
      {"$MODEL M\n$MODEL N\n",
       "model.d:2: a second $MODEL; accepted: one model, without submodels"},
      {"$MODEL M\n$INCLUDE \"/etc/passwd\"\n", "model.d:2: block '$INCLUDE'; accepted: $MODEL, "},
      {"$MODEL M\n$NODES\n$ENDMODEL\n", "model.d: no node in $NODES; accepted: one or more"},
      {"$MODEL M\n$NODES\nF1, T = 0;\n", "model.d:3: 'F1, T = 0'; accepted: a node D, A, B or X"},
      {"$MODEL M\n$NODES\nD1 T = 0;\n", "model.d:3: 'D1 T = 0'; accepted: D10 = 'label', T = 20"},
      {"$MODEL M\n$NODES\nD1, T;\n", "model.d:3: 'D1, T'; accepted: D10 = 'label', T = 20"},
      {"$MODEL M\n$NODES\nD1, T = 0, C = 1;\n\nD1, T = 0;\n",
       "model.d:5: node 1 stands at line 3, too; accepted: numbers used once"},
      {"$MODEL M\n$NODES\nD1, T = 0, C = -1;\n", "model.d:3: node 1 has C -1 J/K and T 273.15 K"},
      {"$MODEL M\n$NODES\nD1, T = -300;\n", "model.d:3: node 1 has C 0 J/K and T -26.85 K"},
      {"$MODEL M\n$NODES\nD1, T = none;\n",
       "model.d:3: 'none' at 'none'; accepted: numbers, constants of $LOCALS and $CONSTANTS"},
      {"$MODEL M\n$LOCALS\na = b;\nb = a;\n$NODES\nD1, T = a;\n",
       "model.d:4: 'a' at 'a'; accepted"},
      {"$MODEL M\n$LOCALS\na;\n", "model.d:3: 'a'; accepted: NAME = expression;"},
      {BEFORE "$CONSTANTS\nA1 = 1/0;\n$CONDUCTORS\nGL(1,2) = A1;\n",
       "model.d:8: 'A1' is not finite"},
      {BEFORE "$CONDUCTORS\nGL(1,2) = SQRT(2);\n", "model.d:6: 'SQRT(2)' at 'SQRT(2)'; accepted"},
      {BEFORE "$CONDUCTORS\nGL(1,2) = 1 + ;\n", "model.d:6: '1 +' at ''; accepted"},
      {BEFORE "$CONDUCTORS\nGL(1,2) = (1 ;\n", "model.d:6: '(1' at ''; accepted"},
      {BEFORE "$CONDUCTORS\nGL(1,3) = 1;\n", "model.d:6: 'GL(1,3) = 1': no node 3"},
      {BEFORE "$CONDUCTORS\nGF(1,2) = 1;\n",
       "model.d:6: 'GF(1,2) = 1'; accepted: GL(10,20) = W/K;"},
      {BEFORE "$CONDUCTORS\nGL(a:1,2) = 1;\n", "model.d:6: 'GL(a:1,2) = 1'; accepted: GL(10,20)"},
      {BEFORE "$CONDUCTORS\nGR(1,2) = -1;\n",
       "model.d:6: 'GR(1,2) = -1'; accepted: two nodes that differ, and GR 0 or more"},
      {BEFORE "$CONDUCTORS\nGL(2,2) = 1;\n", "model.d:6: 'GL(2,2) = 1'; accepted: "},
      {"name,kind\n",
       "model.d: a table of nodes wants a table of conductors; accepted: conductors"},
  };
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
    struct um_thermal_network *network = NULL;
    um_core_message_clear(help_context);
    assert_int_equal(read_text(rows[i].text, &network), UM_ERR_INPUT);
    assert_null(network);
    if (strncmp(um_core_message(help_context), rows[i].says, strlen(rows[i].says)) != 0)
      fail_msg("'%s' says '%s', not '%s'", rows[i].text, um_core_message(help_context),
               rows[i].says);
  }
}

static char folder[UM_TEST_PATH];

static int enter(void **state)
{
  if (um_test_folder_create(folder) != 0 || chdir(folder) != 0) return -1;
  return help_setup(state);
}

static int leave(void **state)
{
  if (help_teardown(state) != 0 || chdir("/") != 0) return -1;
  return um_test_folder_remove(folder);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(says_what_it_says),
      cmocka_unit_test(does_what_is_done_once),
      cmocka_unit_test(round_trip),
      cmocka_unit_test(faults),
  };
  return cmocka_run_group_tests(tests, enter, leave);
}
