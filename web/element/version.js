/** Version of the package, of the program and of the headers. */
export const version = '1.0.0';
