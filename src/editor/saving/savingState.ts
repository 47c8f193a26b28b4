import { useStore } from 'zustand';
import { createStore } from 'zustand/vanilla';

/** A file being made. */
interface SavingJob {
  /** The node that requests it. */
  readonly node: string;
  readonly name: string;
  /** 0 … 1; undefined if unknown. */
  readonly part?: number;
  readonly cancel: () => void;
}

/** The file being made; one at a time. */
export const savingStore = createStore<{ readonly job?: SavingJob | undefined }>(() => ({}));
export const useSaving = <T>(select: (state: { readonly job?: SavingJob | undefined }) => T): T =>
  useStore(savingStore, select);
