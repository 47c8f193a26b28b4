import { Button, Group, Text } from '@mantine/core';
import { type ReactNode, useEffect, useRef, useState } from 'react';
import { createPortal } from 'react-dom';
import type { Lesson, LessonAnswer, LessonQuestion } from '../../lessons/lesson.ts';
import { stateAtStep } from '../../lessons/settings.ts';
import { msg } from '../../messages/message.ts';
import { useTexts } from '../language/languageStore.ts';
import { openErrorOf } from '../projects/projectSource.ts';
import { useServices } from '../services.tsx';
import { useEditor } from '../state/context.tsx';
import { type Answered, loadAnswers, NOTHING, saveAnswers } from './answers.ts';
import { LessonPrint } from './LessonPrint.tsx';
import { Inlines, LessonText } from './LessonText.tsx';
import { showState } from './showState.ts';

interface LessonProps {
  readonly name: string;
  readonly lesson: Lesson;
  /** From 1. */
  readonly step: number;
}

/** The open lesson at one of its steps. */
export function LessonView({ name, lesson, step }: LessonProps): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const [{ chosen, seen }, setAnswered] = useAnswers(name, lesson);
  const { set, text, title, question } = lesson.steps[step - 1]!;
  const isSeen = seen.includes(step);
  useShownStep(name, lesson, step, isSeen);
  const heading = useFocusOnStep(step);
  const go = (to: number) => editor.update({ lesson: { name, step: to } });
  const restart = () => {
    setAnswered(NOTHING);
    go(1);
  };
  return (
    <>
      <h2>{lesson.title}</h2>
      {step === 1 && <LessonText blocks={lesson.summary} />}
      <h3 ref={heading} tabIndex={-1} data-step={step} data-sets={set.length}>
        {title}
      </h3>
      <LessonText blocks={text} />
      {question && (
        <Question
          key={step}
          question={question}
          chosen={chosen[step]}
          isSeen={isSeen}
          onChoose={(answer) => setAnswered({ seen, chosen: { ...chosen, [step]: answer } })}
          onSee={() => setAnswered({ chosen, seen: [...seen, step] })}
        />
      )}
      <Group gap="xs" mt="md" wrap="nowrap">
        <Button size="compact-sm" variant="default" disabled={step === 1} onClick={() => go(step - 1)}>
          {t(msg`Back`)}
        </Button>
        {step < lesson.steps.length ? (
          <Button size="compact-sm" variant={question && !isSeen ? 'default' : 'filled'} onClick={() => go(step + 1)}>
            {t(msg`Next`)}
          </Button>
        ) : (
          <Button size="compact-sm" onClick={() => editor.update({ lesson: { step: 1 } })}>
            {t(msg`All lessons`)}
          </Button>
        )}
        <div className="sl-spring" />
        <Button size="compact-xs" variant="subtle" onClick={restart}>
          {t(msg`Start again`)}
        </Button>
      </Group>
      <Group gap="xs" mt="xs">
        <Button size="compact-xs" variant="subtle" onClick={() => void copyLink(editor, name, step)}>
          {t(msg`Copy link to this step`)}
        </Button>
        <Button size="compact-xs" variant="subtle" onClick={() => print()}>
          {t(msg`Print the lesson`)}
        </Button>
      </Group>
      {createPortal(<LessonPrint lesson={lesson} />, document.body)}
    </>
  );
}

/** What is answered, as it was before the page was left. */
function useAnswers(name: string, { steps }: Lesson): readonly [Answered, (answered: Answered) => void] {
  const [answered, setAnswered] = useState(() =>
    loadAnswers(
      name,
      steps.map(({ question }) => question?.answers.length ?? 0),
    ),
  );
  const answer = (now: Answered) => {
    setAnswered(now);
    saveAnswers(name, now);
  };
  return [answered, answer];
}

/** Keeps project and observer at the state of the step. */
function useShownStep(name: string, lesson: Lesson, step: number, isSeen: boolean): void {
  const editor = useEditor();
  const { observerController, localFiles } = useServices();
  // In another language it is the same lesson.
  const current = useRef(lesson);
  current.current = lesson;
  useEffect(() => {
    const abort = new AbortController();
    showState(
      stateAtStep(current.current, step - 1, isSeen),
      { editor, observerController, localFiles },
      abort.signal,
    ).catch((error: unknown) => {
      if (!abort.signal.aborted) editor.notify({ kind: 'error', ...openErrorOf(name, error) });
    });
    return () => abort.abort();
  }, [editor, observerController, localFiles, name, step, isSeen]);
}

/** On another step its heading takes the focus, so that it is read out and keys go on from there. */
function useFocusOnStep(step: number): React.RefObject<HTMLHeadingElement | null> {
  const heading = useRef<HTMLHeadingElement>(null);
  const last = useRef(step);
  useEffect(() => {
    if (last.current === step) return;
    last.current = step;
    heading.current?.focus();
    heading.current?.scrollIntoView({ block: 'nearest' });
  }, [step]);
  return heading;
}

async function copyLink(editor: ReturnType<typeof useEditor>, name: string, step: number): Promise<void> {
  const link = new URL(`?lesson=${name}&step=${step}`, location.href).href;
  try {
    await navigator.clipboard.writeText(link);
    editor.notify({ kind: 'info', text: msg`The link is copied: ${link}` });
  } catch {
    // Without access to the clipboard it can be copied from the notice.
    editor.notify({ kind: 'info', text: msg`Link to this step: ${link}` });
  }
}

interface QuestionProps {
  readonly question: LessonQuestion;
  readonly chosen: number | undefined;
  readonly isSeen: boolean;
  readonly onChoose: (answer: number) => void;
  readonly onSee: () => void;
}

/** Asked first; after an answer is chosen, it is seen and explained. */
function Question({ question, chosen, isSeen, onChoose, onSee }: QuestionProps): ReactNode {
  const { t } = useTexts();
  const { text, answers, explanation } = question;
  const answer = chosen === undefined ? undefined : answers[chosen];
  return (
    <fieldset className="sl-lesson-question">
      <legend>
        <Inlines parts={text} />
      </legend>
      {answers.map((each, i) => (
        // biome-ignore lint/suspicious/noArrayIndexKey: answers never change their places
        <label key={i} data-right={isSeen ? each.right : undefined}>
          <input type="radio" name="answer" checked={i === chosen} onChange={() => onChoose(i)} />
          <span>
            <Inlines parts={each.text} />
          </span>
        </label>
      ))}
      {!isSeen && (
        <Group gap="xs" mt={4}>
          <Button size="compact-sm" disabled={chosen === undefined} onClick={onSee}>
            {t(msg`See`)}
          </Button>
          <Text size="xs" c="dimmed">
            {chosen === undefined && t(msg`Choose an answer first.`)}
          </Text>
        </Group>
      )}
      <div role="status" className="sl-lesson-verdict">
        {isSeen && answer && (
          <>
            <Verdict answer={answer} right={answers.find((each) => each.right)!} />
            <LessonText blocks={explanation} />
          </>
        )}
      </div>
    </fieldset>
  );
}

function Verdict({ answer, right }: { readonly answer: LessonAnswer; readonly right: LessonAnswer }): ReactNode {
  const { t } = useTexts();
  return (
    <>
      <p>
        <strong>{t(answer.right ? msg`Right.` : msg`Not so.`)}</strong> <Inlines parts={answer.why} />
      </p>
      {!answer.right && (
        <p>
          <strong>{t(msg`Right is:`)}</strong> <Inlines parts={right.text} /> <Inlines parts={right.why} />
        </p>
      )}
    </>
  );
}
