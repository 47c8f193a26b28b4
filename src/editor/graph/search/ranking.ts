/** An entry that can be searched and chosen. */
export interface QuickPickItem {
  readonly id: string;
  readonly label: string;
  /** Heading of its section; entries of a section are consecutive. */
  readonly group: string;
  readonly detail?: string;
  /** Further search terms, such as the name in the other language. */
  readonly words?: string;
  readonly keys?: readonly string[];
  readonly category?: string;
  readonly disabled?: boolean;
}

/**
 * Items that match every word of a query, best first: name starts with the query, then a word of the name starts with
 * it, then it occurs anywhere. Without a query, all in their order.
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
