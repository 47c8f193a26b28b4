import './inspect.css';
import { Menu } from '@mantine/core';
import { type ReactNode, useEffect, useState } from 'react';
import { msg } from '../../messages/message.ts';
import { openDeck } from '../flight/deck/openDeck.ts';
import { followable, placeBefore } from '../flight/deck/targets.ts';
import { toggleHold } from '../flight/hold/hold.ts';
import { useTexts } from '../language/languageStore.ts';
import { useServices } from '../services.tsx';
import { useEditor, useEditorState } from '../state/context.tsx';
import { type PicturePosition, setPointer } from '../viewport/legend/legendState.ts';
import { pickPoint } from './pointReader.ts';

/** What the picture shows at a place. */
interface PlaceContent {
  readonly at: PicturePosition;
  /** Prim path; undefined for the sky. */
  readonly path: string | undefined;
}

/** What can be done with the thing at a place of the picture, and with the picture. */
export default function PictureMenu({ at }: { readonly at: PicturePosition }): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const { observerController, viewport } = useServices();
  const [content, setContent] = useState<PlaceContent>();
  const picture = useEditorState((state) => state.picture);
  const held = useEditorState((state) => state.held);
  const outsideView = useEditorState((state) => state.outsideView);
  const maximized = useEditorState((state) => state.maximized);
  useEffect(() => {
    let isOver = false;
    const show = (path: string | undefined) => isOver || setContent({ at, path });
    const context = viewport.besides?.();
    // If the device was lost, the menu is that of the picture alone.
    (context ? pickPoint(context, at) : Promise.resolve(undefined)).then(
      (point) => show(point?.object.path),
      () => show(undefined),
    );
    return () => {
      isOver = true;
    };
  }, [at, viewport]);
  if (content?.at !== at || !picture) return null;
  const { path } = content;
  const deck = () => openDeck(editor, observerController);
  const flyThere = (to: string) => {
    const { observer } = observerController;
    const destination = placeBefore(picture.scene, to, observer, picture.speedOfLight);
    if (!destination) return editor.notify({ kind: 'info', text: msg`${to} is not there at this moment.` });
    deck().set({ destination });
    deck().choose('autopilot');
  };
  const follow = (followed: string) => {
    deck().set({ followed });
    deck().choose('follow');
  };
  return (
    <Menu
      opened
      withInitialFocusPlaceholder={false}
      onClose={() => editor.update({ pictureMenu: undefined })}
      position="bottom-start"
      shadow="md"
    >
      <Menu.Target>
        <div className="sl-menu-place" style={{ left: `${100 * at[0]}%`, top: `${100 * at[1]}%` }} />
      </Menu.Target>
      <Menu.Dropdown className="sl-picture-menu" aria-label={path ?? t(msg`sky`)}>
        <Menu.Label>
          <bdi>{path ?? t(msg`sky`)}</bdi>
        </Menu.Label>
        <Menu.Item
          onClick={() => {
            setPointer(at);
            editor.update({ tool: 'inspect' });
          }}
        >
          {t(msg`Inspect what is seen`)}
        </Menu.Item>
        {path && <Menu.Item onClick={() => flyThere(path)}>{t(msg`Fly there`)}</Menu.Item>}
        {path && followable(picture.scene).includes(path) && (
          <Menu.Item onClick={() => follow(path)}>{t(msg`Follow it`)}</Menu.Item>
        )}
        <Menu.Item onClick={() => editor.update({ tool: 'measure' })}>{t(msg`Measure lengths`)}</Menu.Item>
        <Menu.Divider />
        <Menu.Item onClick={() => toggleHold(editor, observerController)}>
          {t(held ? msg`Back to your eye` : msg`Hold what you see`)}
        </Menu.Item>
        <Menu.Item onClick={() => editor.update({ outsideView: !outsideView })}>
          {t(outsideView ? msg`Hide the outside view` : msg`Show the outside view`)}
        </Menu.Item>
        <Menu.Item onClick={() => editor.update({ maximized: !maximized })}>
          {t(maximized ? msg`Show the panels` : msg`Only the picture`)}
        </Menu.Item>
        <Menu.Item onClick={() => observerController.restart()}>{t(msg`Back to the start of the scene`)}</Menu.Item>
      </Menu.Dropdown>
    </Menu>
  );
}
