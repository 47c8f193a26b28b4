export type Metric = 'flip' | 'pixels' | 'aov';

export interface CompareFlags {
  readonly metric: Metric;
  readonly output?: string;
  readonly triptych?: boolean;
  readonly channel?: string;
  readonly threshold?: number;
  readonly failAbove?: number;
  readonly max?: number;
  readonly exposure: number;
  readonly json?: boolean;
}
