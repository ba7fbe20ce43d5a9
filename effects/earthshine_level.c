/* Level of the earthshine: sunlight reflected by the Earth, as light only. Its thermal twin is the
 * albedo load, which stays. */
#include "effects/list_impl.h"
#include "environment/environment.h"

static const struct um_effect_parameter parameters[] = {
    {"factor", "1", "factor of the earthshine", 1.0, 1.3, 0.0, 5.0, 0.5},
};

static enum um_status environment(struct um_context *context, const struct um_effect_use *use,
                                  struct um_environment *to)
{
  (void)context;
  to->earthshine_factor *= use->value[0];
  return UM_OK;
}

const struct um_effect um_effects_earthshine_level = {
    .abi_version = UM_EFFECT_ABI_VERSION,
    .struct_size = sizeof(struct um_effect),
    .name = "earthshine_level",
    .summary = "The sunlit Earth is brighter or darker than modelled",
    .reference = "Fankhauser et al. 2023, arXiv 2305.11123",
    .validity = "optics only, heat loads stay; of no effect where earthshine is off",
    .targets = UM_TARGET_GLOBAL,
    .parameters = parameters,
    .nparameter = sizeof parameters / sizeof parameters[0],
    .hooks = {.environment = environment},
};
