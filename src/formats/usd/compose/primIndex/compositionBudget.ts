import type { LayerStore } from '../layers/layerStore.ts';

/** What any stage may take [steps, about 40 ns each]. */
const FREE_STEPS = 6_000_000;
/** What each prim and property that its layers write adds: much as long as they are few, and then as much as a line is worth. */
const STEPS_PER_EARLY_SPEC = 2000;
const EARLY_SPECS = 3000;
const STEPS_PER_SPEC = 100;

/** What things take, in steps: one is to look at one site. */
export const STEP_COSTS = { prim: 20, site: 10, property: 10, item: 10, pair: 60 } as const;

/**
 * What composing a stage takes. A few lines can ask for any number of prims, sites and comparisons: they get as many as
 * take about half a second, and longer files more, as they say more.
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

/** How many steps layers that write so many prims and properties may take. */
export const stepBudget = (specs: number): number =>
  FREE_STEPS + STEPS_PER_EARLY_SPEC * Math.min(specs, EARLY_SPECS) + STEPS_PER_SPEC * specs;
