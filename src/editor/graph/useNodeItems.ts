import { useMemo } from 'react';
import { own } from '../../graph/document.ts';
import type { Level } from '../../graph/sockets.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { inEveryLanguage } from '../i18n/everyLanguage.ts';
import { useTexts } from '../i18n/i18n.ts';
import { additionsFor } from './additions.ts';
import type { Loose } from './fit.ts';
import type { Item } from './ranking.ts';

/** The kinds of nodes that can be added, to be looked for by their names in every language, and by what they offer to choose. */
export function useNodeItems(level: Level, loose?: Loose): readonly Item[] {
  const { any } = useTexts();
  return useMemo(
    () =>
      additionsFor(level, loose).map(
        ({ id, type, title, help, category }): Item => ({
          id,
          label: any(title),
          group: any(`category.${category}`),
          category,
          ...(help && { detail: any(help) }),
          words: `${inEveryLanguage(title)} ${id} ${any(`category.${category}`)} ${choicesOf(type)}`,
        }),
      ),
    [level, loose, any],
  );
}

/** What the parameters of a kind of node offer: who looks for bloom finds the node that has it among its effects. */
export const choicesOf = (type: string): string =>
  Object.values(own(nodeLibrary, type)?.params ?? {})
    .flatMap((spec) => (spec.kind === 'choice' ? spec.options : []))
    .map(({ title }) => inEveryLanguage(title))
    .join(' ');
