import { type KeyboardEvent, type ReactNode, useRef } from 'react';
import { canvas } from '../canvas/canvasState.ts';

interface InlineEditorProps {
  readonly label: string;
  readonly words: string;
  /** Multiline: Enter inserts a line break, Ctrl Enter accepts. */
  readonly long?: boolean;
  readonly take: (words: string) => void;
}

/** A text field in place of the edited text; leaving it accepts, Escape cancels. */
export function InlineEditor({ label, words, long = false, take }: InlineEditorProps): ReactNode {
  const given = useRef(false);
  const end = (written: string | undefined, key: boolean, field: HTMLElement) => {
    if (given.current) return;
    given.current = true;
    if (written !== undefined && written !== words) take(written);
    const node = field.closest<HTMLElement>('.react-flow__node');
    canvas.setState({ editing: undefined });
    if (key) node?.focus();
  };
  const onKeyDown = (event: KeyboardEvent<HTMLInputElement | HTMLTextAreaElement>) => {
    event.stopPropagation();
    const { value } = event.currentTarget;
    if (event.key === 'Escape') end(undefined, true, event.currentTarget);
    else if (event.key === 'Enter' && (!long || event.ctrlKey || event.metaKey)) end(value, true, event.currentTarget);
  };
  const common = {
    'aria-label': label,
    className: 'sl-writing nodrag nopan nowheel',
    defaultValue: words,
    onKeyDown,
    onBlur: (event: React.FocusEvent<HTMLInputElement | HTMLTextAreaElement>) =>
      end(event.currentTarget.value, false, event.currentTarget),
  };
  const focus = (field: HTMLInputElement | HTMLTextAreaElement | null) => {
    field?.select();
    // After a pointer press the canvas takes the focus; take it back.
    if (field) requestAnimationFrame(() => document.activeElement !== field && field.select());
  };
  return long ? <textarea ref={focus} {...common} /> : <input ref={focus} {...common} />;
}
