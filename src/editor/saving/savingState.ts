import { useStore } from 'zustand';
import { createStore } from 'zustand/vanilla';

/** A file that is being made. */
interface SavingJob {
  /** That asked for it. */
  readonly node: string;
  readonly name: string;
  /** 0 … 1; undefined where it cannot be known. */
  readonly part?: number;
  readonly cancel: () => void;
}

/** What the page is making for the person to keep: one file at a time. */
export const savingStore = createStore<{ readonly job?: SavingJob | undefined }>(() => ({}));
export const useSaving = <T>(select: (state: { readonly job?: SavingJob | undefined }) => T): T =>
  useStore(savingStore, select);
