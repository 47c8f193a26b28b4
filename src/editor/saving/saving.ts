import { useStore } from 'zustand';
import { createStore } from 'zustand/vanilla';

/** A file that is being made. */
interface Job {
  /** That asked for it. */
  readonly node: string;
  readonly name: string;
  /** 0 … 1; undefined where it cannot be known. */
  readonly part?: number;
  readonly cancel: () => void;
}

/** What the page is making for the person to keep: one file at a time. */
export const saving = createStore<{ readonly job?: Job | undefined }>(() => ({}));
export const useSaving = <T>(select: (state: { readonly job?: Job | undefined }) => T): T => useStore(saving, select);
