import { useMemo } from 'react';
import type { GraphLevel } from '../../../graph/analysis/sockets.ts';
import { own } from '../../../graph/document/document.ts';
import { nodeLibrary } from '../../../nodes/library.ts';
import { inEveryLanguage } from '../../i18n/everyLanguage.ts';
import { useTexts } from '../../i18n/i18n.ts';
import type { PendingConnection } from '../commands/connections.ts';
import { addableNodes } from './addableNodes.ts';
import type { QuickPickItem } from './ranking.ts';

/** Kinds of nodes that can be added, searchable by their names in all languages and by their options. */
export function useNodeItems(level: GraphLevel, pendingEnd?: PendingConnection): readonly QuickPickItem[] {
  const { textOrKey } = useTexts();
  return useMemo(
    () =>
      addableNodes(level, pendingEnd).map(
        ({ id, type, title, help, category }): QuickPickItem => ({
          id,
          label: textOrKey(title),
          group: textOrKey(`category.${category}`),
          category,
          ...(help && { detail: textOrKey(help) }),
          words: `${inEveryLanguage(title)} ${id} ${textOrKey(`category.${category}`)} ${optionTitles(type)}`,
        }),
      ),
    [level, pendingEnd, textOrKey],
  );
}

/** Titles of a node type's options: searching "bloom" finds the effects node. */
export const optionTitles = (type: string): string =>
  Object.values(own(nodeLibrary, type)?.params ?? {})
    .flatMap((spec) => (spec.kind === 'choice' ? spec.options : []))
    .map(({ title }) => inEveryLanguage(title))
    .join(' ');
