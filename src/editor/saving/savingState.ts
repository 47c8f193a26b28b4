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

interface SavingState {
  /** The file being made; one at a time. */
  readonly job?: SavingJob | undefined;
  /** The notice of why the last one could not be made. */
  readonly refusal?: number | undefined;
}

export const savingStore = createStore<SavingState>(() => ({}));
export const useSaving = <T>(select: (state: SavingState) => T): T => useStore(savingStore, select);
