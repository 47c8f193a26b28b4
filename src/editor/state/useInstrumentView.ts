import { useEffect } from 'react';
import { INSTRUMENTS, type InstrumentName } from '../../lessons/instruments.ts';
import { useEditorState } from './context.tsx';

/** Shows in a panel what a lesson asks for, until the user chooses otherwise. */
export function useInstrumentView<P extends InstrumentName>(
  panel: P,
  show: (view: (typeof INSTRUMENTS)[P][number]) => void,
): void {
  const instrument = useEditorState((state) => state.instrument);
  useEffect(() => {
    const view = instrument?.panel === panel && INSTRUMENTS[panel].find((each) => each === instrument.view);
    if (view) show(view);
  }, [instrument, panel, show]);
}
