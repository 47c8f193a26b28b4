import { useMemo } from 'react';
import type { Level } from '../../graph/sockets.ts';
import { inEveryLanguage } from '../i18n/everyLanguage.ts';
import { useTexts } from '../i18n/i18n.ts';
import { additionsFor } from './additions.ts';
import type { Loose } from './fit.ts';
import type { Item } from './ranking.ts';

/** The kinds of nodes that can be added, to be looked for by their names in every language. */
export function useNodeItems(level: Level, loose?: Loose): readonly Item[] {
  const { any } = useTexts();
  return useMemo(
    () =>
      additionsFor(level, loose).map(
        ({ id, title, help, category }): Item => ({
          id,
          label: any(title),
          group: any(`category.${category}`),
          category,
          ...(help && { detail: any(help) }),
          words: `${inEveryLanguage(title)} ${id} ${any(`category.${category}`)}`,
        }),
      ),
    [level, loose, any],
  );
}
