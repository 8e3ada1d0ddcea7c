/* SPDX-License-Identifier: MIT */
/* Draws triangles and lines with OSMesa, and prints which pixels they have: for scripts/against-mesa.py.
   A line of input: t or l, width, height, then x y of each vertex in clip space. A line of output: the rows of the
   picture from the top, `#` where something was drawn. The first line names the renderer. */
#include <GL/gl.h>
#include <GL/osmesa.h>

#include <stdio.h>
#include <stdlib.h>

enum { largest = 256 };

static unsigned char pixels[largest * largest * 4];

int main(void) {
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 0, 0, 0, NULL);
    char kind = 0;
    int width = 0, height = 0, is_named = 0;
    if (context == NULL)
        return 3;
    while (scanf(" %c %d %d", &kind, &width, &height) == 3) {
        const int corners = kind == 't' ? 3 : 2;
        if (width > largest || height > largest ||
            !OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, width, height))
            return 3;
        OSMesaPixelStore(OSMESA_Y_UP, 0); /* the first row is the top one, as a window has it */
        if (!is_named)
            printf("%s\n", (const char*)glGetString(GL_RENDERER));
        is_named = 1;
        glViewport(0, 0, width, height);
        glClear(GL_COLOR_BUFFER_BIT);
        glBegin(kind == 't' ? GL_TRIANGLES : GL_LINES);
        for (int i = 0; i < corners; ++i) {
            float x = 0, y = 0;
            if (scanf("%f %f", &x, &y) != 2)
                return 2;
            glVertex2f(x, y);
        }
        glEnd();
        glFinish();
        for (int row = 0; row < height; ++row)
            for (int x = 0; x < width; ++x)
                putchar(pixels[4 * (row * width + x)] != 0 ? '#' : '.');
        putchar('\n');
    }
    OSMesaDestroyContext(context);
    return 0;
}
