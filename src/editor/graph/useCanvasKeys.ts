import { useEffect } from 'react';
import { useStudio } from '../state/context.tsx';
import { ACTIONS, type Context, contextOf, leave, nudge } from './actions.ts';
import { canvas, choose } from './canvas.ts';
import { copied, cut, paste } from './clipboard.ts';
import { isPressed } from './keys.ts';

/** Keys and the clipboard, where the focus is on the canvas. */
export function useCanvasKeys(panel: React.RefObject<HTMLElement | null>): void {
  const studio = useStudio();
  useEffect(() => {
    const host = panel.current;
    if (!host) return;
    const onKeyDown = (event: KeyboardEvent) => {
      const context = isWriting(event) ? undefined : contextOf(studio);
      if (!context || !act(context, event)) return;
      event.preventDefault();
      event.stopPropagation();
    };
    const onKeyUp = (event: KeyboardEvent) => {
      if (event.key.startsWith('Arrow')) studio.endGesture();
    };
    host.addEventListener('keydown', onKeyDown);
    host.addEventListener('keyup', onKeyUp);
    return () => {
      host.removeEventListener('keydown', onKeyDown);
      host.removeEventListener('keyup', onKeyUp);
    };
  }, [studio, panel]);
  useEffect(() => {
    const isHere = (event: ClipboardEvent) => !isWriting(event) && panel.current?.contains(document.activeElement);
    const give = (event: ClipboardEvent, words: string | undefined) => {
      if (words === undefined) return;
      event.clipboardData?.setData('text/plain', words);
      event.preventDefault();
    };
    const onCopy = (event: ClipboardEvent) => isHere(event) && give(event, copied(studio));
    const onCut = (event: ClipboardEvent) => isHere(event) && give(event, cut(studio));
    const onPaste = (event: ClipboardEvent) => {
      const words = event.clipboardData?.getData('text/plain');
      if (!isHere(event) || !words) return;
      paste(studio, words);
      event.preventDefault();
    };
    document.addEventListener('copy', onCopy);
    document.addEventListener('cut', onCut);
    document.addEventListener('paste', onPaste);
    return () => {
      document.removeEventListener('copy', onCopy);
      document.removeEventListener('cut', onCut);
      document.removeEventListener('paste', onPaste);
    };
  }, [studio, panel]);
}

const isWriting = ({ target }: Event): boolean =>
  target instanceof HTMLElement && target.matches('input, textarea, select, [contenteditable]');

/** Whether a key means something here, which then is done. */
function act(context: Context, event: KeyboardEvent): boolean {
  if (event.key === 'Escape') return stepBack(context);
  // Buttons on the canvas are pressed with these.
  const isButton = event.target instanceof HTMLElement && event.target.matches('button, a');
  if (isButton && (event.key === 'Enter' || event.key === ' ')) return false;
  const action = ACTIONS.find(({ keys, native }) => !native && keys.some((each) => isPressed(event, each)));
  if (action) {
    if (action.isPossible?.(context) === false) return false;
    action.run(context);
    return true;
  }
  if (event.ctrlKey || event.metaKey || event.altKey) return false;
  return nudge(context, event.key, event.shiftKey);
}

/** What is chosen is let go; then the group is left. */
function stepBack(context: Context): boolean {
  const { chosen, path } = context;
  if (canvas.getState().adding) canvas.setState({ adding: undefined });
  else if (Object.values(chosen).some((list) => list.length > 0)) choose({});
  else if (path.length > 0) leave(context, path.length - 1);
  else return false;
  return true;
}
