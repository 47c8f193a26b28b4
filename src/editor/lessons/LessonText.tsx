import type { ReactNode } from 'react';
import type { LessonBlock, LessonInline } from '../../lessons/lesson.ts';
import { lessonPlaceOf } from '../../lessons/lessonAddress.ts';
import { useEditor } from '../state/context.tsx';

interface TextProps {
  readonly blocks: readonly LessonBlock[];
  /** Whether it stands in a button: paragraphs are spans then. */
  readonly inline?: boolean;
}

/** Paragraphs, lists and formulas of a lesson. */
export function LessonText({ blocks, inline = false }: TextProps): ReactNode {
  const Paragraph = inline ? 'span' : 'p';
  return blocks.map((block, i) => {
    // Blocks of a text never change their places.
    const key = `${block.kind} ${i}`;
    if (block.kind === 'formula')
      return (
        <p key={key} className="sl-lesson-formula">
          {block.text}
        </p>
      );
    if (block.kind === 'paragraph')
      return (
        <Paragraph key={key} className="sl-lesson-paragraph">
          <Inlines parts={block.content} />
        </Paragraph>
      );
    return (
      <ul key={key}>
        {block.items.map((item, nth) => (
          // biome-ignore lint/suspicious/noArrayIndexKey: items of a text never change their places
          <li key={nth}>
            <Inlines parts={item} />
          </li>
        ))}
      </ul>
    );
  });
}

export function Inlines({ parts }: { readonly parts: readonly LessonInline[] }): ReactNode {
  // biome-ignore lint/suspicious/noArrayIndexKey: parts of a text never change their places
  return parts.map((part, i) => <Inline key={i} part={part} />);
}

function Inline({ part }: { readonly part: LessonInline }): ReactNode {
  const editor = useEditor();
  if (typeof part === 'string') return part;
  switch (part.kind) {
    case 'strong':
      return <strong>{part.text}</strong>;
    case 'emphasis':
      return <em>{part.text}</em>;
    case 'code':
      return <code>{part.text}</code>;
    case 'link': {
      const { address, text } = part;
      if (!address.startsWith('?'))
        return (
          <a href={address} target="_blank" rel="noreferrer">
            {text}
          </a>
        );
      return (
        <a
          href={address}
          onClick={(event) => {
            event.preventDefault();
            editor.update({ lesson: lessonPlaceOf(address) });
          }}
        >
          {text}
        </a>
      );
    }
  }
}
