import { Select } from '@mantine/core';
import { type ReactNode, useMemo } from 'react';
import { useStore } from 'zustand';
import { VIGNETTES, type VignetteStrength } from '../../../flight/comfort/vignette.ts';
import { type Message, msg } from '../../../messages/message.ts';
import { useTexts } from '../../language/languageStore.ts';
import { useServices } from '../../services.tsx';
import { useEditor } from '../../state/context.tsx';
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
      <Select
        size="xs"
        label={t(msg`In fast motion`)}
        data={VIGNETTES.map((value) => ({ value, label: t(VIGNETTE_TITLES[value]) }))}
        allowDeselect={false}
        comboboxProps={{ withinPortal: false }}
        value={strength}
        onChange={(vignette) => comfort.set({ vignette: vignette as VignetteStrength })}
      />
      <Select
        size="xs"
        label={t(msg`Turning`)}
        data={[
          { value: '', label: t(msg`Continuously`) },
          ...SNAP_ANGLES.map((angle) => ({ value: `${angle}`, label: t(msg`In steps of ${angle}°`) })),
        ]}
        allowDeselect={false}
        comboboxProps={{ withinPortal: false }}
        value={`${snapAngle ?? ''}`}
        onChange={(value) => comfort.set({ snapAngle: SNAP_ANGLES.find((angle) => `${angle}` === value) })}
      />
    </>
  );
}
