/* Sensitivities of surfaces that exchange radiation: J is joined by E, the derivative of what is
 * exchanged, which is full. Equations (A - s E) x = b are iterated with A's factors
 * (exchange_solve.c); E x is a product (system_exchange.c). What a parameter does to the exchange
 * itself is in its forcing, by the exchange of its own variant. */
#include "thermal/solver/exchange_solve_group.h"
#include "thermal/tangent/sensitivity_impl.h"

enum um_status
um_thermal_sensitivity_exchange_check(const struct um_thermal_sensitivity_subject *of,
                                      const struct um_thermal_variant *variant, size_t nvariant)
{
  const struct um_thermal_exchange *own = of->options->exchange;
  for (size_t k = 0; k < nvariant; k++) {
    const struct um_thermal_solve_options *options = variant[k].options;
    const struct um_thermal_exchange *x = options != NULL ? options->exchange : own;
    if ((x == NULL) != (own == NULL))
      return um_core_fail(of->context, UM_ERR_INPUT,
                          "heat sensitivity %zu: radiation between surfaces is %s the base and %s "
                          "the variant; accepted: in both or in none",
                          k, own != NULL ? "in" : "not in", x != NULL ? "in" : "not in");
    if (x != NULL && x == own && !um_thermal_network_optics_equal(of->network, variant[k].network))
      return um_core_fail(
          of->context, UM_ERR_INPUT,
          "heat sensitivity %zu: the variant has other optics and the base's "
          "exchange between surfaces; accepted: options with an exchange of its own",
          k);
  }
  return UM_OK;
}

static enum um_status inner_solve(void *self, double *x)
{
  struct um_thermal_sensitivity_run *r = self;
  return um_thermal_linear_solve(r->linear, 1, r->share, x);
}

enum um_status um_thermal_sensitivity_solve(struct um_thermal_sensitivity_run *r, double scale,
                                            double share, double *x)
{
  if (r->exchange == NULL) return um_thermal_linear_solve(r->linear, r->ncolumn, share, x);
  const struct um_thermal_inner inner = {inner_solve, r};
  r->share = share;
  for (size_t c = 0; c < r->ncolumn; c++)
    UM_TRY(um_thermal_exchange_solve(r->exchange, &inner, r->matrix, scale, share, x + c * r->n));
  return UM_OK;
}
