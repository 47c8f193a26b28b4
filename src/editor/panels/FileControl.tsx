import { Button, FileButton, Group, Stack } from '@mantine/core';
import type { ReactNode } from 'react';
import type { TextParam } from '../../graph/nodeType.ts';
import { msg } from '../../messages/message.ts';
import { useTexts } from '../language/languageStore.ts';
import { exportedName, namedFile } from '../projects/projectNames.ts';
import { useServices } from '../services.tsx';
import { useEditorState } from '../state/context.tsx';
import { Lines } from './Lines.tsx';
import type { ParamProps } from './paramProps.ts';

/** A file of the project, by its name or chosen from the device. */
export function FileControl({ spec, set, value, onChange }: ParamProps<TextParam>): ReactNode {
  const { t } = useTexts();
  const { localFiles } = useServices();
  const origin = useEditorState(({ history }) => history.origin);
  const take = (name: string) => onChange(namedFile(name, origin, localFiles));
  const choose = (file: File | null) => file && onChange(localFiles.add(new Map([[file.name, file]]), file.name));
  return (
    <Stack gap={4}>
      <Lines {...{ spec, set, onChange, take }} text={exportedName(String(value), origin)} long={false} />
      <Group>
        <FileButton onChange={choose}>
          {(props) => (
            <Button
              {...props}
              size="compact-xs"
              variant="default"
              aria-label={`${t(spec.title)}: ${t(msg`Choose a file…`)}`}
            >
              {t(msg`Choose a file…`)}
            </Button>
          )}
        </FileButton>
      </Group>
    </Stack>
  );
}
