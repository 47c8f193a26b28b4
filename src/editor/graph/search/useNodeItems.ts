import { useMemo } from 'react';
import type { GraphLevel } from '../../../graph/analysis/sockets.ts';
import { own } from '../../../graph/document/document.ts';
import { nodeLibrary } from '../../../nodes/library.ts';
import { inEveryLanguage } from '../../i18n/everyLanguage.ts';
import { useTexts } from '../../i18n/i18n.ts';
import type { PendingConnection } from '../commands/connections.ts';
import { addableNodes } from './addableNodes.ts';
import type { QuickPickItem } from './ranking.ts';

/** The kinds of nodes that can be added, to be looked for by their names in every language, and by what they offer to choose. */
export function useNodeItems(level: GraphLevel, loose?: PendingConnection): readonly QuickPickItem[] {
  const { any } = useTexts();
  return useMemo(
    () =>
      addableNodes(level, loose).map(
        ({ id, type, title, help, category }): QuickPickItem => ({
          id,
          label: any(title),
          group: any(`category.${category}`),
          category,
          ...(help && { detail: any(help) }),
          words: `${inEveryLanguage(title)} ${id} ${any(`category.${category}`)} ${optionTitles(type)}`,
        }),
      ),
    [level, loose, any],
  );
}

/** What the parameters of a kind of node offer: who looks for bloom finds the node that has it among its effects. */
export const optionTitles = (type: string): string =>
  Object.values(own(nodeLibrary, type)?.params ?? {})
    .flatMap((spec) => (spec.kind === 'choice' ? spec.options : []))
    .map(({ title }) => inEveryLanguage(title))
    .join(' ');
