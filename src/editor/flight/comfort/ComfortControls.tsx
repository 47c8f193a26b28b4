import { type ReactNode, useMemo } from 'react';
import { useStore } from 'zustand';
import { VIGNETTES, type VignetteStrength } from '../../../flight/comfort/vignette.ts';
import { type Message, msg } from '../../../messages/message.ts';
import { useTexts } from '../../language/languageStore.ts';
import { useServices } from '../../services.tsx';
import { useEditor } from '../../state/context.tsx';
import { DeckSelect } from '../deck/DeckSelect.tsx';
import { openComfort, SNAP_ANGLES, vignetteOf } from './comfort.ts';

const VIGNETTE_TITLES: Readonly<Record<VignetteStrength, Message>> = {
  off: msg`No vignette`,
  mild: msg`Mild vignette`,
  strong: msg`Strong vignette`,
};

/** Choices of what makes flying comfortable. */
export function ComfortControls(): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const { observerController } = useServices();
  const comfort = useMemo(() => openComfort(editor, observerController), [editor, observerController]);
  const { snapAngle } = useStore(comfort.store);
  const strength = useStore(comfort.store, vignetteOf);
  return (
    <>
      <DeckSelect
        label={t(msg`In fast motion`)}
        options={VIGNETTES.map((value) => [value, VIGNETTE_TITLES[value]])}
        value={strength}
        onChange={(vignette) => comfort.set({ vignette })}
      />
      <DeckSelect
        label={t(msg`Turning`)}
        options={[
          ['', msg`Continuously`],
          ...SNAP_ANGLES.map((angle) => [`${angle}`, msg`In steps of ${angle}°`] as const),
        ]}
        value={`${snapAngle ?? ''}`}
        onChange={(value) => comfort.set({ snapAngle: SNAP_ANGLES.find((angle) => `${angle}` === value) })}
      />
    </>
  );
}
