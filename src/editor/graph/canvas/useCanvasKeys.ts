import { useEffect } from 'react';
import { useEditor } from '../../state/context.tsx';
import { type ActionContext, actionContext, GRAPH_ACTIONS, leaveGroup, nudgeSelection } from '../commands/actions.ts';
import { copySelection, cutSelection, pasteText } from '../commands/clipboard.ts';
import { matchesKeyBinding } from '../commands/keyBindings.ts';
import { canvas, selectItems } from './canvasState.ts';

/** Keyboard shortcuts and clipboard events while the canvas has the focus. */
export function useCanvasKeys(panel: React.RefObject<HTMLElement | null>): void {
  const editor = useEditor();
  useEffect(() => {
    const host = panel.current;
    if (!host) return;
    const onKeyDown = (event: KeyboardEvent) => {
      const context = isWriting(event) ? undefined : actionContext(editor);
      if (!context || !act(context, event)) return;
      event.preventDefault();
      event.stopPropagation();
    };
    const onKeyUp = (event: KeyboardEvent) => {
      if (event.key.startsWith('Arrow')) editor.endGesture();
    };
    host.addEventListener('keydown', onKeyDown);
    host.addEventListener('keyup', onKeyUp);
    return () => {
      host.removeEventListener('keydown', onKeyDown);
      host.removeEventListener('keyup', onKeyUp);
    };
  }, [editor, panel]);
  useEffect(() => {
    const isHere = (event: ClipboardEvent) => !isWriting(event) && panel.current?.contains(document.activeElement);
    const give = (event: ClipboardEvent, words: string | undefined) => {
      if (words === undefined) return;
      event.clipboardData?.setData('text/plain', words);
      event.preventDefault();
    };
    const onCopy = (event: ClipboardEvent) => isHere(event) && give(event, copySelection(editor));
    const onCut = (event: ClipboardEvent) => isHere(event) && give(event, cutSelection(editor));
    const onPaste = (event: ClipboardEvent) => {
      const words = event.clipboardData?.getData('text/plain');
      if (!isHere(event) || !words) return;
      pasteText(editor, words);
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
  }, [editor, panel]);
}

const isWriting = ({ target }: Event): boolean =>
  target instanceof HTMLElement && target.matches('input, textarea, select, [contenteditable]');

/** Runs the action of a key binding; returns whether there is one. */
function act(context: ActionContext, event: KeyboardEvent): boolean {
  if (event.key === 'Escape') return stepBack(context);
  // These keys press focused buttons.
  const isButton = event.target instanceof HTMLElement && event.target.matches('button, a');
  if (isButton && (event.key === 'Enter' || event.key === ' ')) return false;
  const action = GRAPH_ACTIONS.find(
    ({ keys, native }) => !native && keys.some((each) => matchesKeyBinding(event, each)),
  );
  if (action) {
    if (action.isEnabled?.(context) === false) return false;
    action.run(context);
    return true;
  }
  if (event.ctrlKey || event.metaKey || event.altKey) return false;
  return nudgeSelection(context, event.key, event.shiftKey);
}

/** Clears the selection; with nothing selected, leaves the group. */
function stepBack(context: ActionContext): boolean {
  const { selection, path } = context;
  if (canvas.getState().adding) canvas.setState({ adding: undefined });
  else if (Object.values(selection).some((list) => list.length > 0)) selectItems({});
  else if (path.length > 0) leaveGroup(context, path.length - 1);
  else return false;
  return true;
}
