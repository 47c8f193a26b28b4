/** Something that can be looked for and chosen. */
export interface QuickPickItem {
  readonly id: string;
  readonly label: string;
  /** What its kind is called; items of a group follow one another. */
  readonly group: string;
  readonly detail?: string;
  /** Other words that it is found by, as those of the other language. */
  readonly words?: string;
  readonly keys?: readonly string[];
  readonly category?: string;
  readonly disabled?: boolean;
}

/**
 * The items that every word of a query is found in, best first: those whose name begins with it, then in whose name a word does, then that
 * hold it anywhere. Without a query all, as they come.
 */
export function rankItems(items: readonly QuickPickItem[], query: string): readonly QuickPickItem[] {
  const words = query.toLowerCase().split(/\s+/).filter(Boolean);
  if (words.length === 0) return items;
  return items
    .map((item, place) => ({ item, place, rank: Math.max(...words.map((word) => itemRank(item, word))) }))
    .filter(({ rank }) => rank < NO_MATCH)
    .sort((a, b) => a.rank - b.rank || a.place - b.place)
    .map(({ item }) => item);
}

const NO_MATCH = 9;

function itemRank({ label, detail = '', words = '' }: QuickPickItem, word: string): number {
  const name = label.toLowerCase();
  if (name === word) return 0;
  if (name.startsWith(word)) return 1;
  if (name.includes(` ${word}`)) return 2;
  if (` ${words.toLowerCase()}`.includes(` ${word}`)) return 3;
  if (name.includes(word)) return 4;
  return `${words} ${detail}`.toLowerCase().includes(word) ? 5 : NO_MATCH;
}
