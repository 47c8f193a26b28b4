import { Select, type SelectProps } from '@mantine/core';
import type { ReactNode } from 'react';
import { msg } from '../../messages/message.ts';
import { useTexts } from '../language/languageStore.ts';

/** Chooses one of many objects by its path, which can be searched. */
export function ObjectSelect(props: SelectProps): ReactNode {
  const { t } = useTexts();
  return (
    <Select
      size="xs"
      placeholder={t(msg`Search objects…`)}
      nothingFoundMessage={t(msg`No object has this name`)}
      searchable
      limit={50}
      {...props}
    />
  );
}
