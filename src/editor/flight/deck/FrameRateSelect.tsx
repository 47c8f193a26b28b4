import type { ReactNode } from 'react';
import { msg } from '../../../messages/message.ts';
import { useTexts } from '../../language/languageStore.ts';
import { useEditor, useEditorState } from '../../state/context.tsx';
import { FRAME_RATES, loadPreferences, savePreferences } from '../../state/preferences.ts';
import { DeckSelect } from './DeckSelect.tsx';

/** How many pictures a second are drawn at most: fewer save the battery. */
export function FrameRateSelect(): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const chosen = useEditorState((state) => state.frameRate);
  return (
    <DeckSelect
      label={t(msg`Pictures per second`)}
      options={[['', msg`As the screen`], ...FRAME_RATES.map((rate) => [`${rate}`, msg`At most ${rate}`] as const)]}
      value={`${chosen ?? ''}`}
      onChange={(value) => {
        const frameRate = FRAME_RATES.find((rate) => `${rate}` === value);
        editor.update({ frameRate });
        savePreferences({ ...loadPreferences(), frameRate });
      }}
    />
  );
}
