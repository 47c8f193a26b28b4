import { useMemo } from 'react';
import type { GraphLevel } from '../../../graph/analysis/sockets.ts';
import { own } from '../../../graph/document/document.ts';
import { inEnglish, msg, type Translate } from '../../../messages/message.ts';
import { nodeLibrary } from '../../../nodes/library.ts';
import { CATEGORY_TITLES } from '../../../nodes/titles.ts';
import { useTexts } from '../../language/languageStore.ts';
import type { PendingConnection } from '../commands/connections.ts';
import { addableNodes } from './addableNodes.ts';
import type { QuickPickItem } from './ranking.ts';

const CATEGORIES = { ...CATEGORY_TITLES, group: msg`Groups` };

/** Kinds of nodes that can be added, searchable by their names in all languages and by their options. */
export function useNodeItems(level: GraphLevel, pendingEnd?: PendingConnection): readonly QuickPickItem[] {
  const { t } = useTexts();
  return useMemo(
    () =>
      addableNodes(level, pendingEnd).map(
        ({ id, type, title, help, category }): QuickPickItem => ({
          id,
          label: t(title),
          group: t(CATEGORIES[category]),
          category,
          ...(help && { detail: t(help) }),
          words: `${inEnglish(title)} ${t(title)} ${id} ${t(CATEGORIES[category])} ${optionTitles(type, t)}`,
        }),
      ),
    [level, pendingEnd, t],
  );
}

/** Titles of a node type's options: searching "bloom" finds the effects node. */
export const optionTitles = (type: string, t: Translate): string =>
  Object.values(own(nodeLibrary, type)?.params ?? {})
    .flatMap((spec) => (spec.kind === 'choice' ? spec.options : []))
    .map(({ title }) => `${inEnglish(title)} ${t(title)}`)
    .join(' ');
