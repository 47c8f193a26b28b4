import { Text, UnstyledButton } from '@mantine/core';
import type { ReactNode } from 'react';
import { msg } from '../../messages/message.ts';
import { useTexts } from '../language/languageStore.ts';
import { useEditor } from '../state/context.tsx';
import { LessonText } from './LessonText.tsx';
import type { NamedLesson } from './lessonFiles.ts';

export function LessonList({ lessons }: { readonly lessons: readonly NamedLesson[] }): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  return (
    <>
      <h2>{t(msg`Lessons`)}</h2>
      <p>{t(msg`Each step sets the picture. Say first what you will see, then look.`)}</p>
      <ul className="sl-list">
        {lessons.map(({ name, lesson }) => (
          <li key={name}>
            <UnstyledButton
              className="sl-lesson-card"
              data-lesson={name}
              onClick={() => editor.update({ lesson: { name, step: 1 } })}
            >
              <Text fw={600} size="sm">
                {lesson.title}
              </Text>
              <LessonText blocks={lesson.summary} inline />
              <Text size="xs" c="dimmed">
                {t(msg`${lesson.steps.length} steps, about ${lesson.minutes} minutes`)}
              </Text>
            </UnstyledButton>
          </li>
        ))}
      </ul>
    </>
  );
}
