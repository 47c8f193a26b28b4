import type { LayerStore } from './layerStore.ts';

/** What any stage may take, and what each prim and property that its layers write adds to that [steps, about 50 ns each]. */
const FREE_STEPS = 12_000_000;
const STEPS_PER_SPEC = 100;

/** What things take, in steps: one is to look at one site. */
export const STEPS = { prim: 20, site: 10, property: 10, item: 10, pair: 60 } as const;

/**
 * What composing a stage takes. A few lines can ask for any number of prims, sites and comparisons: they get as many as
 * take about a second, and long files more, as they say more.
 */
export class Work {
  private readonly store: LayerStore;
  private steps = 0;

  constructor(store: LayerStore) {
    this.store = store;
  }

  spend(steps: number): void {
    this.steps += steps;
  }

  get isTooMuch(): boolean {
    return this.steps > FREE_STEPS + STEPS_PER_SPEC * this.store.specs;
  }
}
