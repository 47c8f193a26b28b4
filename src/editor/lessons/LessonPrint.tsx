import type { ReactNode } from 'react';
import type { Lesson } from '../../lessons/lesson.ts';
import { msg } from '../../messages/message.ts';
import { useTexts } from '../language/languageStore.ts';
import { Inlines, LessonText } from './LessonText.tsx';

/** The whole lesson, as it is printed: all steps with their questions, and the answers on a page of their own. */
export function LessonPrint({ lesson: { title, summary, steps } }: { readonly lesson: Lesson }): ReactNode {
  const { t } = useTexts();
  const numbered = steps.map((step, i) => ({ ...step, number: i + 1 }));
  return (
    <article className="sl-lesson-print">
      <h1>{title}</h1>
      <LessonText blocks={summary} />
      {numbered.map(({ number, title, text, question }) => (
        <section key={number}>
          <h2>{t(msg`${number}. ${title}`)}</h2>
          <LessonText blocks={text} />
          {question && (
            <>
              <p>
                <strong>
                  <Inlines parts={question.text} />
                </strong>
              </p>
              <ul className="sl-lesson-boxes">
                {question.answers.map((answer, i) => (
                  // biome-ignore lint/suspicious/noArrayIndexKey: answers never change their places
                  <li key={i}>
                    <Inlines parts={answer.text} />
                  </li>
                ))}
              </ul>
            </>
          )}
        </section>
      ))}
      <section className="sl-lesson-answers">
        <h2>{t(msg`Answers`)}</h2>
        {numbered.map(
          ({ number, title, question }) =>
            question && (
              <section key={number}>
                <h3>{t(msg`${number}. ${title}`)}</h3>
                {question.answers.map((answer, i) => (
                  // biome-ignore lint/suspicious/noArrayIndexKey: answers never change their places
                  <p key={i}>
                    {answer.right ? '☑' : '☐'} <Inlines parts={answer.text} /> <Inlines parts={answer.why} />
                  </p>
                ))}
                <LessonText blocks={question.explanation} />
              </section>
            ),
        )}
      </section>
    </article>
  );
}
