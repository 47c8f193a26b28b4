import { type ReactNode, Suspense, useState } from 'react';
import { useEditorState, useTelemetry } from '../../state/context.tsx';
import type { EditorState } from '../../state/editor.ts';

/** What waits for the first picture, which comes sooner without it; but not for one that takes long. */
export function AfterFirstPicture({ children }: { readonly children: ReactNode }): ReactNode {
  const drawn = useTelemetry((live) => live.drawn);
  const late = useEditorState(isLate);
  const [begun, setBegun] = useState(false);
  if ((drawn || late) && !begun) setBegun(true);
  return begun && <Suspense>{children}</Suspense>;
}

/** Whether there will be no picture, more than reading files comes before it, or panels are asked for besides the controls. */
const isLate = ({ graphics, notices, loading, results, picture, graph, lesson }: EditorState): boolean =>
  graphics === 'failed' ||
  graph ||
  lesson !== undefined ||
  notices.length > 0 ||
  (loading ? loading.stage === 'trace' || loading.stage === 'simulate' : results.size > 0 && !picture);
