import './lessons.css';
import { ActionIcon, Group, Text } from '@mantine/core';
import { IconList, IconX } from '@tabler/icons-react';
import { type ReactNode, useEffect, useState } from 'react';
import type { LessonPlace } from '../../lessons/lessonAddress.ts';
import type { LanguageTag } from '../../messages/languages.ts';
import { msg } from '../../messages/message.ts';
import { messageOf } from '../../messages/messageError.ts';
import { useTexts } from '../language/languageStore.ts';
import { useEditor, useEditorState } from '../state/context.tsx';
import type { Editor } from '../state/editor.ts';
import { LessonList } from './LessonList.tsx';
import { LessonView } from './LessonView.tsx';
import { loadLessons, type NamedLesson } from './lessonFiles.ts';

/** The list of lessons, or the open one. */
export default function LessonPanel(): ReactNode {
  const { t, language } = useTexts();
  const editor = useEditor();
  const place = useEditorState((state) => state.lesson);
  const lessons = useLessons(language);
  const open = lessons?.find(({ name }) => name === place?.name);
  useEffect(() => {
    if (lessons) refuseWrongPlace(editor, lessons, place);
  }, [editor, lessons, place]);
  const isPlaced = open !== undefined && place !== undefined && isStepOf(open, place.step);
  return (
    <div className="sl-panel sl-lessons" data-lessons>
      <Group gap={4} wrap="nowrap" className="sl-lessons-bar">
        <Text size="xs" c="dimmed" className="sl-spring">
          {isPlaced && t(msg`Step ${place.step} of ${open.lesson.steps.length}`)}
        </Text>
        {isPlaced && (
          <ActionIcon
            size="sm"
            variant="subtle"
            color="gray"
            aria-label={t(msg`All lessons`)}
            onClick={() => editor.update({ lesson: { step: 1 } })}
          >
            <IconList size={16} />
          </ActionIcon>
        )}
        <ActionIcon
          size="sm"
          variant="subtle"
          color="gray"
          aria-label={t(msg`Close lessons`)}
          onClick={() => editor.update({ lesson: undefined })}
        >
          <IconX size={16} />
        </ActionIcon>
      </Group>
      {/* A list that was scrolled does not leave the lesson scrolled. */}
      <div className="sl-lessons-page" key={isPlaced ? open.name : ''}>
        {isPlaced ? (
          <LessonView name={open.name} lesson={open.lesson} step={place.step} />
        ) : (
          lessons && <LessonList lessons={lessons} />
        )}
      </div>
    </div>
  );
}

/** The lessons of a language; while another is loaded, those of the one before. */
function useLessons(language: LanguageTag): readonly NamedLesson[] | undefined {
  const editor = useEditor();
  const [lessons, setLessons] = useState<readonly NamedLesson[]>();
  useEffect(() => {
    let isWanted = true;
    loadLessons(language).then(
      (loaded) => isWanted && setLessons(loaded),
      (error: unknown) => editor.notify({ kind: 'error', text: messageOf(error) }),
    );
    return () => {
      isWanted = false;
    };
  }, [editor, language]);
  return lessons;
}

const isStepOf = ({ lesson }: NamedLesson, step: number): boolean =>
  Number.isInteger(step) && step >= 1 && step <= lesson.steps.length;

/** Says what is wrong with a link, and goes to what is nearest: the list, or the first step. */
function refuseWrongPlace(editor: Editor, lessons: readonly NamedLesson[], place: LessonPlace | undefined): void {
  if (place?.name === undefined) return;
  const named = lessons.find(({ name }) => name === place.name);
  if (named && isStepOf(named, place.step)) return;
  if (!named) {
    editor.notify({
      kind: 'error',
      text: msg`The link asks for the lesson “${place.name}”, which is not there. Choose one of the list.`,
    });
    editor.update({ lesson: { step: 1 } });
  } else {
    editor.notify({
      kind: 'warning',
      text: msg`The link asks for step ${String(place.step)}; this lesson has the steps 1 to ${named.lesson.steps.length}. It begins with the first.`,
    });
    editor.update({ lesson: { name: place.name, step: 1 } });
  }
}
