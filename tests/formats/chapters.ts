import type { Group } from './row.ts';
import { usdGroups } from './usd.ts';

export interface Chapter {
  readonly title: string;
  /** The guide that tells more. */
  readonly guide: string;
  readonly groups: readonly Group[];
}

export const chapters: readonly Chapter[] = [{ title: 'OpenUSD', guide: 'usd.md', groups: usdGroups }];
