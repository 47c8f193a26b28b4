import type { LayerStore } from '../layers/layerStore.ts';

/** Base budget of any stage [steps, about 40 ns each]. */
const FREE_STEPS = 6_000_000;
/** Budget added per spec in the layers, larger for the first ones. */
const STEPS_PER_EARLY_SPEC = 2000;
const EARLY_SPECS = 3000;
const STEPS_PER_SPEC = 100;

/** Costs in steps; one step visits one site. */
export const STEP_COSTS = { prim: 20, site: 10, property: 10, item: 10, pair: 60 } as const;

/**
 * Budget of composing a stage: a few lines can request any number of prims, sites and comparisons. Small files get
 * about half a second, larger ones more in proportion to their specs.
 */
export class CompositionBudget {
  private readonly store: LayerStore;
  private steps = 0;

  constructor(store: LayerStore) {
    this.store = store;
  }

  spend(steps: number): void {
    this.steps += steps;
  }

  get isExhausted(): boolean {
    return this.steps > stepBudget(this.store.specs);
  }
}

/** Steps granted for a number of specs. */
export const stepBudget = (specs: number): number =>
  FREE_STEPS + STEPS_PER_EARLY_SPEC * Math.min(specs, EARLY_SPECS) + STEPS_PER_SPEC * specs;
